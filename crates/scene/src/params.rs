//! What a kind says of its parameters, once: name, meaning, unit, range, default.
//!
//! The scene file's reader, its JSON Schema, `--set`, the property panels and the tables of the docs all come from these
//! descriptions. A kind is a struct declared by [`params!`](crate::params!); a family of kinds (all shapes, all
//! lights) is an enum declared by [`kinds!`](crate::kinds!).

use std::fmt;
use vitrine_math::{Rgb, Vec3};

/// The value of one parameter, in transit between a kind and a file, a panel or a script.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Not stated. Only parameters that are optional take it.
    Nothing,
    /// Yes or no.
    Flag(bool),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f32),
    /// Two whole numbers: width and height.
    Size([i64; 2]),
    /// Two numbers.
    Pair([f32; 2]),
    /// Three numbers: x, y, z.
    Vector(Vec3),
    /// A linear colour.
    Color(Rgb),
    /// A name, a choice, a path or a remark.
    Text(String),
    /// Points in space.
    Points(Vec<Vec3>),
    /// Points of a picture, u and v.
    Pairs(Vec<[f32; 2]>),
}

/// The numbers that a parameter takes. Infinities and NaN are never among them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// The least.
    pub min: f32,
    /// The greatest.
    pub max: f32,
    /// Whether `min` itself is refused.
    pub above_min: bool,
}

impl Range {
    /// Any finite number.
    pub const ANY: Self = Self::from_to(f32::MIN, f32::MAX);
    /// 0 to 1.
    pub const UNIT: Self = Self::from_to(0.0, 1.0);
    /// More than 0.
    pub const POSITIVE: Self = Self { min: 0.0, max: f32::MAX, above_min: true };
    /// 0 or more.
    pub const NOT_NEGATIVE: Self = Self::from_to(0.0, f32::MAX);

    /// Both ends belong to it.
    #[must_use]
    pub const fn from_to(min: f32, max: f32) -> Self {
        Self { min, max, above_min: false }
    }

    /// Whether the number is allowed.
    #[must_use]
    pub fn contains(&self, v: f32) -> bool {
        v.is_finite() && v <= self.max && if self.above_min { v > self.min } else { v >= self.min }
    }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let from = if self.above_min { "more than" } else { "from" };
        match (self.min > f32::MIN, self.max < f32::MAX) {
            (false, false) => f.write_str("any finite number"),
            (true, false) if self.above_min => write!(f, "more than {}", self.min),
            (true, false) => write!(f, "{} or more", self.min),
            (false, true) => write!(f, "{} or less", self.max),
            (true, true) if self.above_min => write!(f, "{from} {}, {} at most", self.min, self.max),
            (true, true) => write!(f, "{from} {} to {}", self.min, self.max),
        }
    }
}

/// Which list of the scene a name refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ListName {
    /// `[[object]]`
    Object,
    /// `[[light]]`
    Light,
    /// `[[material]]`
    Material,
    /// `[[texture]]`
    Texture,
    /// `[[group]]`
    Group,
}

impl ListName {
    /// All of them, in the order of a scene file.
    pub const ALL: [Self; 5] = [Self::Light, Self::Texture, Self::Material, Self::Group, Self::Object];

    /// The word in files: "object", "light", …
    #[must_use]
    pub const fn key(self) -> &'static str {
        match self {
            Self::Object => "object",
            Self::Light => "light",
            Self::Material => "material",
            Self::Texture => "texture",
            Self::Group => "group",
        }
    }
}

/// What a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParamKind {
    /// `true` or `false`.
    Flag,
    /// A whole number, both ends allowed.
    Integer {
        /// The least.
        min: i64,
        /// The greatest.
        max: i64,
    },
    /// A number.
    Number(Range),
    /// Width and height in whole pixels, both ends allowed for each.
    Size {
        /// The least.
        min: i64,
        /// The greatest.
        max: i64,
    },
    /// Two numbers, each in the range.
    Pair(Range),
    /// x, y, z, each in the range.
    Vector(Range),
    /// x, y, z, not all zero.
    Direction,
    /// Factors along x, y, z, none zero; files may give one number for all three.
    Scale,
    /// A colour: "#rrggbb" (sRGB) or [r, g, b] (linear, 0 or more).
    Color,
    /// So many points in space.
    Points(usize),
    /// So many pairs of numbers.
    Pairs(usize),
    /// One of these words.
    Choice(&'static [&'static str]),
    /// Any text.
    Text,
    /// The name of something in that list.
    Reference(ListName),
    /// The path of a file, relative to the scene file.
    File,
}

/// A parameter's unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A bare number.
    None,
    /// Metres.
    Metres,
    /// Degrees.
    Degrees,
    /// Pixels.
    Pixels,
    /// Millionths of a metre.
    Micrometres,
    /// Kelvin.
    Kelvin,
    /// Seconds.
    Seconds,
}

impl Unit {
    /// The sign after a value: "m", "°", "px", "µm", "K", "s" or nothing.
    #[must_use]
    pub const fn sign(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Metres => "m",
            Self::Degrees => "°",
            Self::Pixels => "px",
            Self::Micrometres => "µm",
            Self::Kelvin => "K",
            Self::Seconds => "s",
        }
    }
}

/// The description of one parameter.
#[derive(Clone, Copy, Debug)]
pub struct ParamSpec {
    /// Its key in files, `--set` and scripts.
    pub name: &'static str,
    /// What it means, in plain English.
    pub doc: &'static str,
    /// What it takes.
    pub kind: ParamKind,
    /// The unit of its numbers.
    pub unit: Unit,
    /// Its value where nothing is stated.
    pub default: fn() -> Value,
    /// Whether a file must state it.
    pub required: bool,
}

impl ParamSpec {
    /// Whether "not stated" is a value of its own, different from any that can be stated.
    #[must_use]
    pub fn is_optional(&self) -> bool {
        (self.default)() == Value::Nothing
    }

    /// The key under which locales keep its label: "param-turn_deg".
    #[must_use]
    pub fn label_key(&self) -> String {
        format!("param-{}", self.name)
    }

    /// Checks a value against the kind.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self, value: &Value) -> Result<(), ParamError> {
        if *value == Value::Nothing && self.is_optional() {
            return Ok(());
        }
        let fits = match (self.kind, value) {
            (ParamKind::Flag, Value::Flag(_))
            | (ParamKind::Text | ParamKind::Reference(_), Value::Text(_)) => true,
            (ParamKind::File, Value::Text(t)) => !t.trim().is_empty(),
            (ParamKind::Integer { min, max }, Value::Integer(v)) => (min..=max).contains(v),
            (ParamKind::Number(range), Value::Number(v)) => range.contains(*v),
            (ParamKind::Size { min, max }, Value::Size(s)) => s.iter().all(|v| (min..=max).contains(v)),
            (ParamKind::Pair(range), Value::Pair(p)) => p.iter().all(|v| range.contains(*v)),
            (ParamKind::Vector(range), Value::Vector(v)) => v.to_array().iter().all(|v| range.contains(*v)),
            (ParamKind::Direction, Value::Vector(v)) => v.is_finite() && v.length_squared() > 0.0,
            (ParamKind::Scale, Value::Vector(v)) => v.is_finite() && v.recip().is_finite(),
            (ParamKind::Color, Value::Color(c)) => c.is_finite() && c.to_array().iter().all(|c| *c >= 0.0),
            (ParamKind::Points(n), Value::Points(p)) => p.len() == n && p.iter().all(|p| p.is_finite()),
            (ParamKind::Pairs(n), Value::Pairs(p)) => {
                p.len() == n && p.iter().flatten().all(|v| v.is_finite())
            }
            (ParamKind::Choice(words), Value::Text(t)) => words.contains(&t.as_str()),
            _ => return Err(ParamError::WrongType { name: self.name, allowed: self.allowed() }),
        };
        if fits { Ok(()) } else { Err(ParamError::NotAllowed { name: self.name, allowed: self.allowed() }) }
    }

    /// What it takes, in words: "a number, from 0 to 1".
    #[must_use]
    pub fn allowed(&self) -> String {
        match self.kind {
            ParamKind::Flag => "true or false".into(),
            ParamKind::Integer { min, max } => format!("a whole number from {min} to {max}"),
            ParamKind::Number(r) if r == Range::ANY => "a finite number".into(),
            ParamKind::Number(r) => format!("a number, {r}"),
            ParamKind::Size { min, max } => {
                format!("[width, height], whole numbers from {min} to {max}")
            }
            ParamKind::Pair(r) if r == Range::ANY => "[u, v], finite numbers".into(),
            ParamKind::Pair(r) => format!("[u, v], each {r}"),
            ParamKind::Vector(r) if r == Range::ANY => "[x, y, z], finite numbers".into(),
            ParamKind::Vector(r) => format!("[x, y, z], each {r}"),
            ParamKind::Direction => "[x, y, z], finite numbers that are not all zero".into(),
            ParamKind::Scale => "a number or [x, y, z], none of them zero".into(),
            ParamKind::Color => "\"#rrggbb\" (sRGB) or [r, g, b] (linear, 0 or more)".into(),
            ParamKind::Points(n) => format!("{n} points, [[x, y, z], …], finite numbers"),
            ParamKind::Pairs(n) => format!("{n} pairs, [[u, v], …], finite numbers"),
            ParamKind::Choice(words) => {
                let quoted: Vec<_> = words.iter().map(|w| format!("\"{w}\"")).collect();
                quoted.join(", ")
            }
            ParamKind::Text => "a text in quotes".into(),
            ParamKind::Reference(list) => format!("the name of a [[{}]], in quotes", list.key()),
            ParamKind::File => "the path of a file in quotes, relative to the scene file".into(),
        }
    }
}

/// Why a parameter was not set.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ParamError {
    /// There is no such parameter.
    #[error("unknown key `{name}`")]
    Unknown {
        /// The name as given.
        name: String,
    },
    /// The value is of another type.
    #[error("`{name}` has the wrong type")]
    WrongType {
        /// The parameter.
        name: &'static str,
        /// What it takes.
        allowed: String,
    },
    /// The value is of the right type and out of range.
    #[error("this value of `{name}` is not allowed")]
    NotAllowed {
        /// The parameter.
        name: &'static str,
        /// What it takes.
        allowed: String,
    },
}

/// Something with described parameters.
pub trait Params {
    /// The descriptions, in the order in which a file writes them.
    fn specs(&self) -> &'static [ParamSpec];

    /// The value of a parameter, or None when there is none of that name.
    fn get(&self, name: &str) -> Option<Value>;

    /// Stores a value that has been checked; false when the name or the type does not fit. Call [`set`] instead.
    fn store(&mut self, name: &str, value: Value) -> bool;
}

/// Sets one parameter after checking the value against its description. Every way into a scene goes through here.
///
/// # Errors
/// [`ParamError`]; then nothing has changed.
pub fn set(target: &mut dyn Params, name: &str, value: Value) -> Result<(), ParamError> {
    let unknown = || ParamError::Unknown { name: name.to_owned() };
    let spec = target.specs().iter().find(|s| s.name == name).ok_or_else(unknown)?;
    spec.check(&value)?;
    if target.store(name, value) {
        Ok(())
    } else {
        Err(ParamError::WrongType { name: spec.name, allowed: spec.allowed() })
    }
}

/// A Rust type that a parameter can have.
pub trait ParamValue: Sized {
    /// Into transit.
    fn to_value(&self) -> Value;
    /// Out of transit; None when the type does not fit.
    fn from_value(value: Value) -> Option<Self>;
}

macro_rules! param_value {
    ($($type:ty: $variant:ident($v:ident) => $into:expr, $back:expr;)*) => {$(
        impl ParamValue for $type {
            fn to_value(&self) -> Value { let $v = self; Value::$variant($into) }
            fn from_value(value: Value) -> Option<Self> {
                match value { Value::$variant($v) => $back, _ => None }
            }
        }
    )*};
}

param_value! {
    bool: Flag(v) => *v, Some(v);
    u32: Integer(v) => i64::from(*v), u32::try_from(v).ok();
    f32: Number(v) => *v, Some(v);
    [u32; 2]: Size(v) => v.map(i64::from), {
        let [w, h] = v.map(u32::try_from);
        Some([w.ok()?, h.ok()?])
    };
    [f32; 2]: Pair(v) => *v, Some(v);
    Vec3: Vector(v) => *v, Some(v);
    Rgb: Color(v) => *v, Some(v);
    String: Text(v) => v.clone(), Some(v);
    [Vec3; 3]: Points(v) => v.to_vec(), v.try_into().ok();
    [[f32; 2]; 3]: Pairs(v) => v.to_vec(), v.try_into().ok();
}

impl<T: ParamValue> ParamValue for Option<T> {
    fn to_value(&self) -> Value {
        self.as_ref().map_or(Value::Nothing, T::to_value)
    }
    fn from_value(value: Value) -> Option<Self> {
        if value == Value::Nothing { Some(None) } else { T::from_value(value).map(Some) }
    }
}

/// One kind of a family, for whoever lists them.
#[derive(Clone, Copy, Debug)]
pub struct KindSpec {
    /// The word in files: "sphere".
    pub name: &'static str,
    /// What it is, in plain English.
    pub doc: &'static str,
    /// Its own parameters.
    pub specs: &'static [ParamSpec],
}
