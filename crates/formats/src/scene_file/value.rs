//! A TOML value as the scene's value, by what a parameter takes.

use std::ops::Range as Span;
use toml_edit::Value as Toml;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{ParamKind, ParamSpec, Range, Value, closest};

/// Why a value was refused.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct BadValue {
    /// The part that is to blame; None when it is the whole value.
    pub span: Option<Span<usize>>,
    /// What is wrong.
    pub message: String,
    /// A few words for the underlined place.
    pub label: String,
    /// What is allowed or meant.
    pub help: String,
}

/// Longer values are shortened in messages.
const MOST_SHOWN: usize = 40;

/// Reads one value with its text.
pub(super) fn read_value(spec: &ParamSpec, value: &Toml, source: &str) -> Result<Value, BadValue> {
    let reader = ValueReader { spec, source };
    let read = reader.read(value)?;
    spec.check(&read).map_err(|_| reader.not_allowed(value))?;
    Ok(read)
}

/// A number, whole or not; None when it is something else.
pub(super) fn read_number(value: &Toml, source: &str) -> Option<f32> {
    match value {
        Toml::Integer(n) => Some(*n.value() as f32),
        Toml::Float(number) => {
            // By its text: through f64 some numbers would be rounded twice.
            let text = value.span().and_then(|span| source.get(span));
            let read = text.and_then(|t| t.replace('_', "").parse().ok());
            Some(read.unwrap_or(*number.value() as f32))
        }
        _ => None,
    }
}

/// What a TOML value is, in words.
pub(super) fn type_words(value: &Toml) -> &'static str {
    match value {
        Toml::String(_) => "a text",
        Toml::Integer(_) => "a whole number",
        Toml::Float(_) => "a number with a fraction",
        Toml::Boolean(_) => "true or false",
        Toml::Datetime(_) => "a date or time",
        Toml::Array(_) => "a list",
        Toml::InlineTable(_) => "a table",
    }
}

struct ValueReader<'a> {
    spec: &'a ParamSpec,
    source: &'a str,
}

impl ValueReader<'_> {
    fn read(&self, value: &Toml) -> Result<Value, BadValue> {
        let wrong = || self.wrong_type(value);
        Ok(match self.spec.kind {
            ParamKind::Flag => Value::Flag(value.as_bool().ok_or_else(wrong)?),
            ParamKind::Integer { .. } => Value::Integer(value.as_integer().ok_or_else(wrong)?),
            ParamKind::Number(range) => Value::Number(self.number(value, range)?),
            ParamKind::Size { min, max } => Value::Size(self.size(value, min..=max)?),
            ParamKind::Pair(range) => Value::Pair(self.numbers(value, range)?),
            ParamKind::Vector(range) => Value::Vector(self.numbers(value, range)?.into()),
            ParamKind::Direction => Value::Vector(self.numbers(value, Range::ANY)?.into()),
            ParamKind::Scale => Value::Vector(self.scale(value)?),
            ParamKind::Color => Value::Color(self.color(value)?),
            ParamKind::Points(count) => {
                let points = self.rows::<3>(value, count, "points")?;
                Value::Points(points.into_iter().map(Vec3::from).collect())
            }
            ParamKind::Pairs(count) => Value::Pairs(self.rows::<2>(value, count, "pairs")?),
            ParamKind::Choice(_) | ParamKind::Text | ParamKind::Reference(_) | ParamKind::File => {
                Value::Text(value.as_str().ok_or_else(wrong)?.to_owned())
            }
        })
    }

    fn scale(&self, value: &Toml) -> Result<Vec3, BadValue> {
        if value.is_array() {
            return Ok(self.numbers(value, Range::ANY)?.into());
        }
        Ok(Vec3::splat(self.number(value, Range::ANY)?))
    }

    fn color(&self, value: &Toml) -> Result<Rgb, BadValue> {
        if value.is_array() {
            return Ok(self.numbers(value, Range::NOT_NEGATIVE)?.into());
        }
        let text = value.as_str().ok_or_else(|| self.wrong_type(value))?;
        Rgb::from_hex(text).map_err(|_| BadValue {
            span: None,
            message: format!("`{}` = {} is no colour", self.spec.name, self.shown(value)),
            label: "no colour".into(),
            help: self.takes(),
        })
    }

    fn size(&self, value: &Toml, allowed: std::ops::RangeInclusive<i64>) -> Result<[i64; 2], BadValue> {
        let array = value.as_array().ok_or_else(|| self.wrong_type(value))?;
        let values: Vec<&Toml> = array.iter().collect();
        let &[width, height] = &values[..] else { return Err(self.wrong_count(values.len(), 2, "numbers")) };
        let whole = |v: &Toml| match v.as_integer() {
            Some(n) if allowed.contains(&n) => Ok(n),
            Some(_) => Err(self.not_allowed(v)),
            None => Err(self.wrong_element(v, "whole numbers")),
        };
        Ok([whole(width)?, whole(height)?])
    }

    /// So many lists of N numbers.
    fn rows<const N: usize>(
        &self,
        value: &Toml,
        count: usize,
        what: &str,
    ) -> Result<Vec<[f32; N]>, BadValue> {
        let array = value.as_array().ok_or_else(|| self.wrong_type(value))?;
        if array.len() != count {
            return Err(self.wrong_count(array.len(), count, what));
        }
        let row = |v: &Toml| {
            if v.is_array() { self.numbers(v, Range::ANY) } else { Err(self.wrong_element(v, what)) }
        };
        array.iter().map(row).collect()
    }

    /// N numbers in brackets, each in the range.
    fn numbers<const N: usize>(&self, value: &Toml, range: Range) -> Result<[f32; N], BadValue> {
        let array = value.as_array().ok_or_else(|| self.wrong_type(value))?;
        if array.len() != N {
            return Err(BadValue { span: value.span(), ..self.wrong_count(array.len(), N, "numbers") });
        }
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(array) {
            if !matches!(element, Toml::Integer(_) | Toml::Float(_)) {
                return Err(self.wrong_element(element, "numbers"));
            }
            *number = self.number(element, range)?;
        }
        Ok(numbers)
    }

    fn number(&self, value: &Toml, range: Range) -> Result<f32, BadValue> {
        let number = read_number(value, self.source).ok_or_else(|| self.wrong_type(value))?;
        if !number.is_finite() {
            let is_written_so = value.as_float().is_some_and(|f| !f.is_finite());
            let label = if is_written_so { "not a finite number" } else { "too large a number" };
            return Err(BadValue { label: label.into(), ..self.not_allowed(value) });
        }
        if range.contains(number) { Ok(number) } else { Err(self.not_allowed(value)) }
    }

    fn wrong_type(&self, value: &Toml) -> BadValue {
        let (found, name) = (type_words(value), self.spec.name);
        let unquoted = value.as_str().filter(|text| self.would_take(text));
        BadValue {
            span: value.span(),
            message: format!("`{name}` takes {}, not {found}", noun(self.spec.kind)),
            label: found.into(),
            help: unquoted
                .map_or_else(|| self.takes(), |text| format!("write it without quotes: {name} = {text}")),
        }
    }

    fn wrong_element(&self, element: &Toml, wanted: &str) -> BadValue {
        let found = type_words(element);
        BadValue {
            span: element.span(),
            message: format!("`{}` takes {wanted}, and this is {found}", self.spec.name),
            label: found.into(),
            help: self.takes(),
        }
    }

    fn wrong_count(&self, found: usize, wanted: usize, what: &str) -> BadValue {
        BadValue {
            span: None,
            message: format!("`{}` takes {wanted} {what}, not {found}", self.spec.name),
            label: format!("{found} in place of {wanted}"),
            help: self.takes(),
        }
    }

    fn not_allowed(&self, value: &Toml) -> BadValue {
        let near = match self.spec.kind {
            ParamKind::Choice(words) => value.as_str().and_then(|t| closest(t, words.iter().copied())),
            _ => None,
        };
        BadValue {
            span: value.span(),
            message: format!("`{}` cannot be {}", self.spec.name, self.shown(value)),
            label: "not allowed".into(),
            help: near.map_or_else(|| self.takes(), |word| format!("did you mean \"{word}\"?")),
        }
    }

    fn takes(&self) -> String {
        format!("`{}` takes {}", self.spec.name, self.spec.allowed())
    }

    /// Whether the parameter takes what stands in these quotes.
    fn would_take(&self, text: &str) -> bool {
        let parsed = text.trim().parse::<Toml>();
        parsed.is_ok_and(|v| !v.is_str() && read_value(self.spec, &v, text).is_ok())
    }

    /// The value as the file writes it.
    fn text(&self, value: &Toml) -> Option<&str> {
        self.source.get(value.span()?)
    }

    fn shown(&self, value: &Toml) -> String {
        let text = self.text(value).map_or_else(|| value.to_string(), str::to_owned);
        let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        match line.char_indices().nth(MOST_SHOWN) {
            Some((end, _)) => format!("{}…", &line[..end]),
            None => line,
        }
    }
}

/// What a parameter takes, in as few words as possible.
fn noun(kind: ParamKind) -> &'static str {
    match kind {
        ParamKind::Flag => "true or false",
        ParamKind::Integer { .. } => "a whole number",
        ParamKind::Number(_) => "a number",
        ParamKind::Size { .. } => "[width, height]",
        ParamKind::Pair(_) => "[u, v]",
        ParamKind::Vector(_) | ParamKind::Direction => "[x, y, z]",
        ParamKind::Scale => "a number or [x, y, z]",
        ParamKind::Color => "a colour",
        ParamKind::Points(_) => "a list of points",
        ParamKind::Pairs(_) => "a list of pairs",
        ParamKind::Choice(_) | ParamKind::Text => "a text in quotes",
        ParamKind::Reference(_) => "a name in quotes",
        ParamKind::File => "a file's path in quotes",
    }
}
