//! Numbers as a person types and reads them.

/// A number, or a small sum such as "2*3" or "1/3"; a decimal comma and the unit's sign are understood. None for anything
/// else, and for what has no finite value.
pub(super) fn parse(text: &str, unit: &str) -> Option<f64> {
    let text = text.trim().replace(',', ".").replace(['−', '–'], "-");
    let text = if unit.is_empty() { text.as_str() } else { text.trim_end_matches(unit) };
    let mut rest = text.trim();
    let value = sum(&mut rest)?;
    (rest.trim().is_empty() && value.is_finite()).then_some(value)
}

fn sum(rest: &mut &str) -> Option<f64> {
    let mut value = product(rest)?;
    loop {
        if take(rest, '+') {
            value += product(rest)?;
        } else if take(rest, '-') {
            value -= product(rest)?;
        } else {
            return Some(value);
        }
    }
}

fn product(rest: &mut &str) -> Option<f64> {
    let mut value = number(rest)?;
    loop {
        if take(rest, '*') || take(rest, '×') {
            value *= number(rest)?;
        } else if take(rest, '/') {
            value /= number(rest)?;
        } else {
            return Some(value);
        }
    }
}

fn number(rest: &mut &str) -> Option<f64> {
    let text = rest.trim_start();
    let mut end = 0;
    for (i, c) in text.char_indices() {
        let before = &text[..i];
        let is_sign = matches!(c, '-' | '+') && (i == 0 || before.ends_with(['e', 'E']));
        if !(c.is_ascii_digit() || c == '.' || is_sign || (matches!(c, 'e' | 'E') && i > 0)) {
            break;
        }
        end = i + c.len_utf8();
    }
    *rest = &text[end..];
    text[..end].parse().ok()
}

fn take(rest: &mut &str, c: char) -> bool {
    let found = rest.trim_start().strip_prefix(c);
    found.map(|after| *rest = after).is_some()
}

/// A number with at most so many decimals and no needless zeros.
pub(super) fn format(value: f64, decimals: usize) -> String {
    let magnitude = value.abs();
    if decimals > 0
        && (magnitude >= 1e7 || (magnitude > 0.0 && magnitude < 0.5 * 0.1_f64.powi(decimals as i32)))
    {
        return format!("{:e}", value as f32);
    }
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_commas_units_and_small_sums_are_understood() {
        for (text, value) in [
            ("1.5", 1.5),
            (" -0,25 m ", -0.25),
            ("2*3", 6.0),
            ("1/4", 0.25),
            ("1e-3", 0.001),
            ("3 - 1 + 0.5", 2.5),
            ("-2*-3", 6.0),
            ("−7", -7.0),
        ] {
            assert_eq!(parse(text, "m"), Some(value), "{text}");
        }
    }

    #[test]
    fn nonsense_is_no_number() {
        for text in ["", "abc", "1.2.3", "1/0", "2*", "nan", "inf", "1 2", "--", "5 px"] {
            assert_eq!(parse(text, "m"), None, "{text}");
        }
    }

    #[test]
    fn what_is_shown_has_no_needless_digits() {
        let shown = |v| format(v, 3);
        assert_eq!(
            ["0.5", "2", "-1.25", "0", "0.333"],
            [0.5, 2.0, -1.25, -0.000_000, 1.0 / 3.0].map(shown).each_ref().map(String::as_str)
        );
        assert_eq!(format(1e-5, 3), "1e-5");
        assert_eq!(format(2.5e9, 3), "2.5e9");
    }
}
