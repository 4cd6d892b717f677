//! The scene's values as a file writes them.

use std::fmt;
use vitrine_math::{Rgb, Vec3};
use vitrine_scene::{ParamKind, Value};

/// The text of a value, in parts so that a change in one part of a list leaves the others alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum ValueText {
    /// A number, a text, true or false.
    One(String),
    /// A list in brackets.
    List(Vec<Self>),
}

/// Where there are two ways to write a value: a colour, or equal factors along x, y and z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    /// The short way: "#rrggbb", one number.
    Short,
    /// A list of three numbers.
    List,
}

impl ValueText {
    /// The text of a value; None for one that is not stated.
    pub fn of(value: &Value, kind: ParamKind, style: Style) -> Option<Self> {
        let short = style == Style::Short;
        Some(match value {
            Value::Nothing => return None,
            Value::Flag(flag) => Self::One(flag.to_string()),
            Value::Integer(n) => Self::One(n.to_string()),
            Value::Number(n) => Self::One(number_text(*n)),
            Value::Size(size) => Self::List(size.map(|n| Self::One(n.to_string())).into()),
            Value::Pair(pair) => Self::numbers(pair),
            Value::Vector(v) if short && kind == ParamKind::Scale && *v == Vec3::splat(v.x) => {
                Self::One(number_text(v.x))
            }
            Value::Vector(v) => Self::vector(v),
            Value::Color(color) => Self::color(*color, short),
            Value::Text(text) => Self::One(string_text(text)),
            Value::Points(points) => Self::List(points.iter().map(Self::vector).collect()),
            Value::Pairs(pairs) => Self::List(pairs.iter().map(|p| Self::numbers(p)).collect()),
        })
    }

    fn color(color: Rgb, short: bool) -> Self {
        match color.to_hex() {
            Some(hex) if short => Self::One(string_text(&hex)),
            _ => Self::numbers(&color.to_array()),
        }
    }

    fn vector(v: &Vec3) -> Self {
        Self::numbers(&v.to_array())
    }

    fn numbers(numbers: &[f32]) -> Self {
        Self::List(numbers.iter().map(|n| Self::One(number_text(*n))).collect())
    }
}

impl fmt::Display for ValueText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One(text) => f.write_str(text),
            Self::List(parts) => {
                f.write_str("[")?;
                for (i, part) in parts.iter().enumerate() {
                    let comma = if i == 0 { "" } else { ", " };
                    write!(f, "{comma}{part}")?;
                }
                f.write_str("]")
            }
        }
    }
}

/// The shortest decimal that reads back as the same number; always with a point or an exponent.
pub(super) fn number_text(number: f32) -> String {
    if number.is_finite() { format!("{number:?}") } else { number.to_string().to_lowercase() }
}

/// A text in double quotes, on one line whatever is in it.
pub(super) fn string_text(text: &str) -> String {
    let mut quoted = String::with_capacity(text.len() + 2);
    quoted.push('"');
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            c if c.is_control() => quoted.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_always_read_as_numbers_with_a_fraction() {
        let texts = [0.1, 1.0, -2.5, 1e20, 1e-7, 0.0, f32::MAX, f32::MIN_POSITIVE].map(number_text);
        assert_eq!(texts, ["0.1", "1.0", "-2.5", "1e20", "1e-7", "0.0", "3.4028235e38", "1.1754944e-38"]);
    }

    #[test]
    fn colours_are_hexadecimal_where_that_is_exact() {
        let text =
            |color, style| ValueText::of(&Value::Color(color), ParamKind::Color, style).unwrap().to_string();
        let red = Rgb::from_hex("#c8281e").unwrap();
        assert_eq!(text(red, Style::Short), "\"#c8281e\"");
        assert_eq!(text(Rgb::new(1.0, 0.0, 0.0), Style::List), "[1.0, 0.0, 0.0]");
        assert_eq!(text(Rgb::new(0.1, 0.25, 2.0), Style::Short), "[0.1, 0.25, 2.0]");
    }

    #[test]
    fn quotes_backslashes_and_control_characters_are_escaped() {
        assert_eq!(string_text("a\"b\\c\nd\u{7f}"), r#""a\"b\\c\nd\u007F""#);
        assert_eq!(string_text("мяч 🔮"), "\"мяч 🔮\"");
    }
}
