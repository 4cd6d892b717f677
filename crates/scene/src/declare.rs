//! The words with which kinds declare themselves: [`params!`](crate::params!) for a struct with described parameters,
//! [`kinds!`](crate::kinds!) for a family of kinds, [`choices!`](crate::choices!) for a parameter that is one of some words.

/// Declares a struct with described parameters.
///
/// Each parameter reads `/// meaning` `name: Type = default => kind, unit;` with an optional `required` at the end.
/// Fields that are not parameters stand first, in a block `@plain { … }`.
#[macro_export]
macro_rules! params {
    (
        $(#[doc = $doc:literal])*
        pub struct $name:ident {
            $(@plain { $($(#[$plain_meta:meta])* $plain:ident: $plain_type:ty = $plain_default:expr;)* })?
            $($(#[doc = $field_doc:literal])* $field:ident: $type:ty = $default:expr => $kind:expr, $unit:ident $(, $required:ident)?;)*
        }
    ) => {
        $(#[doc = $doc])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($($(#[$plain_meta])* pub $plain: $plain_type,)*)?
            $($(#[doc = $field_doc])* pub $field: $type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($($plain: $plain_default,)*)? $($field: $default,)* }
            }
        }

        impl $name {
            /// What this is, in plain English.
            pub const DOC: &'static str = concat!($($doc, "\n",)*);
            /// Its parameters, in the order in which a file writes them.
            pub const SPECS: &'static [$crate::ParamSpec] = &[$($crate::ParamSpec {
                name: stringify!($field),
                doc: concat!($($field_doc, "\n",)*),
                kind: $kind,
                unit: $crate::Unit::$unit,
                default: || <$type as $crate::ParamValue>::to_value(&$default),
                required: $crate::params!(@required $($required)?),
            },)*];
        }

        impl $crate::Params for $name {
            fn specs(&self) -> &'static [$crate::ParamSpec] { Self::SPECS }

            fn get(&self, name: &str) -> Option<$crate::Value> {
                match name {
                    $(stringify!($field) => Some($crate::ParamValue::to_value(&self.$field)),)*
                    _ => None,
                }
            }

            fn store(&mut self, name: &str, value: $crate::Value) -> bool {
                match name {
                    $(stringify!($field) => match $crate::ParamValue::from_value(value) {
                        Some(v) => { self.$field = v; true }
                        None => false,
                    },)*
                    _ => { let _ = value; false }
                }
            }
        }
    };
    (@required required) => { true };
    (@required) => { false };
}

/// Declares a family of kinds: the enum, and the register that files, panels and docs read.
#[macro_export]
macro_rules! kinds {
    (
        $(#[$meta:meta])*
        pub enum $family:ident as $trait:ident {
            $($variant:ident($type:ty) = $word:literal,)*
        }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Debug, PartialEq)]
        pub enum $family {
            $(#[doc = concat!("\"", $word, "\"")] $variant($type),)*
        }

        impl $family {
            /// The register of kinds.
            pub const KINDS: &'static [$crate::KindSpec] = &[$($crate::KindSpec {
                name: $word, doc: <$type>::DOC, specs: <$type>::SPECS,
            },)*];

            /// A new one of that kind with every default, or None when the word is no kind.
            #[must_use]
            pub fn from_kind(word: &str) -> Option<Self> {
                match word { $($word => Some(Self::$variant(<$type>::default())),)* _ => None }
            }

            /// The word for this kind in files.
            #[must_use]
            pub const fn kind(&self) -> &'static str {
                match self { $(Self::$variant(_) => $word,)* }
            }

            /// What every kind of the family can do.
            #[must_use]
            pub fn as_kind(&self) -> &dyn $trait {
                match self { $(Self::$variant(k) => k,)* }
            }

            /// Its own parameters, to change.
            pub fn params_mut(&mut self) -> &mut dyn $crate::Params {
                match self { $(Self::$variant(k) => k,)* }
            }
        }
    };
}

/// Declares an enum of words, a parameter that is a choice.
#[macro_export]
macro_rules! choices {
    (
        $(#[$meta:meta])*
        pub enum $name:ident { $($(#[$variant_meta:meta])* $variant:ident = $word:literal,)* }
    ) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name { $($(#[$variant_meta])* $variant,)* }

        impl $name {
            /// The words, in order.
            pub const WORDS: &'static [&'static str] = &[$($word,)*];

            /// The choice that a word names.
            #[must_use]
            pub fn from_word(word: &str) -> Option<Self> {
                match word { $($word => Some(Self::$variant),)* _ => None }
            }

            /// Its word in files.
            #[must_use]
            pub const fn word(self) -> &'static str {
                match self { $(Self::$variant => $word,)* }
            }
        }

        impl $crate::ParamValue for $name {
            fn to_value(&self) -> $crate::Value { $crate::Value::Text(self.word().to_owned()) }
            fn from_value(value: $crate::Value) -> Option<Self> {
                match value { $crate::Value::Text(t) => Self::from_word(&t), _ => None }
            }
        }
    };
}
