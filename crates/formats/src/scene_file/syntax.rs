//! Text that is not TOML: what is wrong in plain words, and a hint.

use super::finding::Finding;
use std::ops::Range;
use toml_edit::TomlError;

const NUMBER_HINT: &str = "a number is written 5, -0.5 or 1e-3, and a text stands in quotes";

/// The parser's words, ours, and how to mend it. The first whose words the parser's message starts with counts.
const CAUSES: &[(&str, &str, &str)] = &[
    ("duplicate key", "this key or section stands twice", "keep one of the two"),
    ("`_` may only go between digits", "this is no number", NUMBER_HINT),
    ("redundant", "this is no number", NUMBER_HINT),
    ("invalid float", "this is no number", NUMBER_HINT),
    ("invalid integer", "this is no number", NUMBER_HINT),
    ("invalid boolean", "this is no value", "write true or false in small letters"),
    ("invalid basic string", "the text is not closed", "write \" at its end"),
    ("invalid literal string", "the text is not closed", "write ' at its end"),
    ("invalid multi-line", "the text is not closed", "write three quotes at its end"),
    ("string values must be quoted", "a text must stand in quotes", "write \"…\""),
    (
        "invalid value",
        "this is no value",
        "a value is a number, true, false, a text in quotes or a list in brackets",
    ),
    ("missing value", "the value is missing", "write it after the ="),
    (
        "key with no value",
        "this is neither a key with a value nor a header",
        "write key = value, [section] or [[list]]",
    ),
    (
        "unquoted keys cannot be empty",
        "the name of a key or section is missing here",
        "write key = value, [section] or [[list]]",
    ),
    (
        "invalid unquoted key",
        "a key or section cannot have this name",
        "keys consist of Latin letters, digits, - and _",
    ),
    ("extra `=`", "there is one = too many", "write key = value"),
    (
        "unexpected key or value",
        "something stands between this value and the end of the line",
        "each key has a line of its own; decimals have a point: 0.5",
    ),
    (
        "missing escaped value",
        "a backslash in a text needs a second one",
        "write \\\\, or / in the path of a file",
    ),
    (
        "too few unicode value digits",
        "a backslash in a text needs a second one",
        "write \\\\, or / in the path of a file",
    ),
    ("missing comma", "a comma is missing between two values", "write [1, 2, 3]"),
    ("extra comma", "there is one comma too many", "write [1, 2, 3]"),
    ("unclosed array table", "the header is not closed", "write [[object]] with two brackets at each end"),
    ("unclosed array", "the list is not closed", "write ] at its end"),
    ("unclosed inline table", "the braces are not closed", "write } at the end"),
    ("unclosed table", "the header is not closed", "write [camera] with a bracket at each end"),
    ("unexpected leading zero", "a number cannot start with 0 and another digit", "leave the first 0 out"),
    ("integer number overflowed", "the number is too large", "write a smaller one"),
    ("floating-point number overflowed", "the number is too large", "write a smaller one"),
    (
        "cannot recurse further",
        "brackets stand too deep inside one another",
        "no value of a scene needs more than two levels",
    ),
    ("recursion limit", "a key has far too many dots", "no key of a scene needs more than one dot"),
    (
        "carriage return must be followed by newline",
        "a line ends in a way that is not known",
        "save the file with the line ends of Windows or Unix",
    ),
];

const NUMBER_STARTS: [char; 13] = ['0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '+', '-', '.'];

/// What the parser says about this text, as a finding.
pub(super) fn syntax_finding(error: &TomlError, text: &str) -> Finding {
    let span = shown_span(error.span().unwrap_or_else(|| dotted_line(text)), text);
    let rest = &text[span.start..];
    let starts_with = |chars: &[char]| rest.starts_with(chars);
    let (words, hint) = match error.message() {
        _ if starts_with(&['“', '”', '„', '«', '»', '‘', '’']) => {
            ("this is not a straight quote", "write \"")
        }
        m if m.starts_with("string values") && span.is_empty() => {
            ("the value is missing", "write it after the =")
        }
        m if m.starts_with("string values")
            && starts_with(&NUMBER_STARTS)
            && text[span.clone()].contains(' ') =>
        {
            ("here are several values", "write one value, or a list: [1, 2, 3]")
        }
        m if m.starts_with("string values") && starts_with(&NUMBER_STARTS) => {
            ("this is no number", NUMBER_HINT)
        }
        message => match CAUSES.iter().find(|(start, ..)| message.starts_with(start)) {
            Some((_, words, hint)) => (*words, *hint),
            None => {
                let help = "a line is key = value, [section], [[list]] or # a remark";
                return Finding::error(span, format!("this is not TOML: {message}"), "here", help);
            }
        },
    };
    Finding::error(span, words, "here", hint)
}

/// The line with far too many dots: the one error for which the parser names no place.
fn dotted_line(text: &str) -> Range<usize> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let key = line.split('=').next().unwrap_or(line);
        if key.matches('.').count() >= 80 {
            return start..start + line.trim_end().len();
        }
        start += line.len();
    }
    0..0
}

/// The span cut to whole characters within the text, and to one line.
fn shown_span(span: Range<usize>, text: &str) -> Range<usize> {
    let whole = |mut at: usize| {
        at = at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        at
    };
    let (start, end) = (whole(span.start), whole(span.end.max(span.start)));
    let line_end = text[start..end].find('\n').map_or(end, |at| start + at);
    start..line_end
}
