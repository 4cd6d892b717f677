//! A changed scene into the text of its file: what has not changed stays as it was written, to the byte.
//!
//! The text is cut into pieces, one for each section or entry that stands under a header. A piece goes from the
//! remarks right above its header to its last key; what follows up to the next piece (blank lines, remarks on their
//! own) belongs to the place and not to the piece. Pieces are edited, moved, left out or added, and joined again.

use super::edit::{Edit, Lines, entry_edits, statement_edits};
use super::finding::Findings;
use super::outline::{Entry, Outline};
use super::pairing::pair;
use super::section::{FORMAT_KEY, Section};
use super::view::View;
use std::ops::Range;
use toml_edit::{Document, Table};
use vitrine_scene::{ListName, Owner, Scene};

/// The text of a file that says `old`, changed so that it says `new`.
pub(super) fn print(text: &str, old: &Scene, new: &Scene) -> String {
    let Ok(document) = Document::parse(text) else { return super::print_new(new) };
    let root = document.as_table();
    let outline = Outline::read(root, &mut Findings::default());
    let mut printer = Printer::new(text, root, &outline);
    // An empty line says as much as none: only a change of it is a reason to touch it.
    if new.about != old.about {
        printer.about(new);
    }
    printer.single(Owner::Settings, &View::single(Section::SETTINGS, &new.settings));
    printer.single(Owner::Camera, &View::single(Section::CAMERA, &new.camera));
    for list in ListName::ALL {
        printer.list(list, &View::list(old, list), &View::list(new, list));
    }
    printer.join()
}

/// A section or entry with a header, or what stands above the first one.
struct Piece {
    /// Whose; None above the first header.
    owner: Option<Owner>,
    /// Its bytes, whole lines.
    range: Range<usize>,
}

/// What comes to a place in the file.
enum Block {
    /// The piece of that index, with its edits.
    Piece(usize),
    /// A new section or entry.
    New(String),
}

struct Printer<'a> {
    lines: Lines<'a>,
    root: Entry<'a>,
    root_table: &'a Table,
    outline: &'a Outline<'a>,
    pieces: Vec<Piece>,
    /// What stands at the place of each piece.
    places: Vec<Vec<Block>>,
    edits: Vec<Edit>,
}

impl<'a> Printer<'a> {
    fn new(text: &'a str, root_table: &'a Table, outline: &'a Outline<'a>) -> Self {
        let lines = Lines::new(text);
        let pieces = pieces(lines, root_table, outline);
        let places = (0..pieces.len()).map(|index| vec![Block::Piece(index)]).collect();
        let root = Entry { table: root_table, span: 0..0, has_header: true };
        Self { lines, root, root_table, outline, pieces, places, edits: Vec::new() }
    }

    /// The line on what the scene shows.
    fn about(&mut self, scene: &Scene) {
        let result = statement_edits(&self.root, &View::about(scene), FORMAT_KEY, self.lines);
        self.edits.extend(result.edits);
    }

    /// A section that stands once.
    fn single(&mut self, owner: Owner, view: &View) {
        let outline = self.outline;
        if let Some(entry) = outline.entry(owner) {
            let result = entry_edits(entry, view, self.lines);
            if entry.has_header || !result.has_lines {
                return self.edits.extend(result.edits);
            }
            self.remove_from_root(view.section);
        }
        if !view.is_default() {
            self.add_section(view);
        }
    }

    /// A list.
    fn list(&mut self, list: ListName, old: &[View], new: &[View]) {
        let entries = self.outline.list(list);
        let pairs = pair(old, new);
        let results = new.iter().zip(&pairs).map(|(view, pair)| {
            pair.and_then(|index| entries.get(index)).map(|entry| entry_edits(entry, view, self.lines))
        });
        let results: Vec<_> = results.collect();
        if entries.iter().all(|e| e.has_header) {
            self.edits.extend(results.into_iter().flatten().flat_map(|r| r.edits));
            return self.arrange(list, new, &pairs);
        }
        let is_in_place = entries.len() == new.len() && pairs.iter().enumerate().all(|(i, p)| *p == Some(i));
        if is_in_place && results.iter().flatten().all(|r| !r.has_lines) {
            self.edits.extend(results.into_iter().flatten().flat_map(|r| r.edits));
        } else {
            self.remove_from_root(Section::of_list(list));
            new.iter().for_each(|view| self.add_section(view));
        }
    }

    /// Puts the entries of a list into their order: each place that keeps an entry takes the next one that stays.
    fn arrange(&mut self, list: ListName, new: &[View], pairs: &[Option<usize>]) {
        let is_of_list = |owner| matches!(owner, Some(Owner::Item(l, _)) if l == list);
        let own: Vec<usize> = (0..self.pieces.len()).filter(|i| is_of_list(self.pieces[*i].owner)).collect();
        own.iter().for_each(|place| self.places[*place].clear());
        let mut stays = vec![false; own.len()];
        pairs.iter().flatten().for_each(|index| stays[*index] = true);
        let mut places = own.iter().zip(stays).filter(|(_, stays)| *stays).map(|(place, _)| *place);
        let mut first = Vec::new();
        let mut place = None;
        for (view, pair) in new.iter().zip(pairs) {
            let block = match pair {
                Some(index) => {
                    place = places.next();
                    Block::Piece(own[*index])
                }
                None => Block::New(view.block(self.lines.newline)),
            };
            match place {
                Some(place) => self.places[place].push(block),
                None => first.push(block),
            }
        }
        let Some(section) = new.first().map(|v| v.section) else { return };
        let target = own.iter().copied().find(|place| !self.places[*place].is_empty());
        let target = target.or(own.first().copied()).unwrap_or_else(|| self.place_after(section));
        let is_own = own.contains(&target);
        let at = if is_own { 0 } else { self.places[target].len() };
        self.places[target].splice(at..at, first);
    }

    /// Adds a new section behind those that belong before it.
    fn add_section(&mut self, view: &View) {
        let place = self.place_after(view.section);
        self.places[place].push(Block::New(view.block(self.lines.newline)));
    }

    /// The last place of a section that belongs before this one, or above the first header.
    fn place_after(&self, section: Section) -> usize {
        let rank = |word: &str| Section::all().position(|s| s.word == word);
        let of_piece = |piece: &Piece| match piece.owner? {
            Owner::Settings => rank(Section::SETTINGS.word),
            Owner::Camera => rank(Section::CAMERA.word),
            Owner::Item(list, _) => rank(list.key()),
        };
        let own = rank(section.word);
        self.pieces.iter().rposition(|p| of_piece(p) <= own).unwrap_or(0)
    }

    /// Takes out all lines above the first header that belong to a section.
    fn remove_from_root(&mut self, section: Section) {
        for (path, value) in self.root_table.get_values() {
            let (Some(first), Some(last)) = (path.first(), path.last()) else { continue };
            if let (true, Some(key), Some(value)) = (first.get() == section.word, last.span(), value.span()) {
                self.edits.push(self.lines.removal(&key, &value));
            }
        }
    }

    /// The new text.
    fn join(mut self) -> String {
        self.edits.sort_by_key(|e| e.range.start);
        let text = self.lines.text;
        let mut joined = Joined { text: String::with_capacity(text.len()), newline: self.lines.newline };
        for (index, blocks) in self.places.iter().enumerate() {
            for (i, block) in blocks.iter().enumerate() {
                if i > 0 || (index == 0 && matches!(block, Block::New(_))) {
                    joined.end_paragraph();
                }
                match block {
                    Block::Piece(index) => self.push_piece(*index, &mut joined),
                    Block::New(block) => joined.push(block),
                }
            }
            let next = self.pieces.get(index + 1).map_or(text.len(), |p| p.range.start);
            let between = &text[self.pieces[index].range.end..next];
            // The blank lines after a piece that is gone go with it, remarks stay.
            if !blocks.is_empty() || !between.trim().is_empty() {
                joined.push(between);
            } else if index + 1 == self.pieces.len() {
                joined.trim_end();
            }
        }
        joined.text
    }

    fn push_piece(&self, index: usize, joined: &mut Joined) {
        let Range { start, end } = self.pieces[index].range;
        let first = self.edits.partition_point(|e| e.range.start < start);
        // A line can come behind the last one of the text, where nothing else begins.
        let is_last = end == self.lines.text.len();
        let own = self.edits[first..].iter().take_while(|e| e.range.start < end || is_last);
        let mut at = start;
        let mut piece = String::with_capacity(end - start);
        for edit in own {
            piece += &self.lines.text[at..edit.range.start];
            piece += &edit.text;
            at = edit.range.end;
        }
        piece += &self.lines.text[at..end];
        joined.push(&piece);
    }
}

/// Cuts the text into pieces.
fn pieces(lines: Lines, root: &Table, outline: &Outline) -> Vec<Piece> {
    let lists = ListName::ALL
        .into_iter()
        .flat_map(|list| (0..outline.list(list).len()).map(move |index| Owner::Item(list, index)));
    let owners = [Owner::Settings, Owner::Camera].into_iter().chain(lists);
    let entries = owners.filter_map(|owner| outline.entry(owner).map(|entry| (owner, entry)));
    let mut entries: Vec<_> = entries.filter(|(_, entry)| entry.has_header).collect();
    entries.sort_by_key(|(_, entry)| entry.span.start);

    let end_of_root =
        root.get_values().iter().filter_map(|(_, v)| v.span()).map(|s| s.end).max().unwrap_or(0);
    let mut pieces = vec![Piece { owner: None, range: 0..lines.next(end_of_root) }];
    for (owner, entry) in entries {
        let before = pieces.last().map_or(0, |p| p.range.end);
        let values = entry.table.get_values();
        let end = values.iter().filter_map(|(_, v)| v.span()).map(|s| s.end).max().unwrap_or(entry.span.end);
        let mut start = lines.start(entry.span.start);
        while start > before && lines.text[lines.start(start - 1)..start].trim_start().starts_with('#') {
            start = lines.start(start - 1);
        }
        pieces.push(Piece { owner: Some(owner), range: start..lines.next(end) });
    }
    pieces
}

/// Text that grows by whole lines.
struct Joined {
    text: String,
    newline: &'static str,
}

impl Joined {
    fn push(&mut self, lines: &str) {
        if !lines.is_empty() {
            self.end_line();
            self.text += lines;
        }
    }

    fn end_line(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with('\n') {
            self.text += self.newline;
        }
    }

    /// A blank line, unless there is one.
    fn end_paragraph(&mut self) {
        self.end_line();
        let last = self.text.trim_end_matches(['\n', '\r']).len();
        if last > 0 && self.text[last..].matches('\n').count() < 2 {
            self.text += self.newline;
        }
    }

    /// No blank lines at the end.
    fn trim_end(&mut self) {
        self.text.truncate(self.text.trim_end().len());
        self.end_line();
    }
}
