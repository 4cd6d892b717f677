//! The one equation behind balls and shells. Bouguer's law says that b = n ρ sin(angle with the radius) is the same all
//! along a path through concentric spheres, so the path is plane and the angle that it sweeps around the centre is
//!
//!   Θ(b) = c₀ + Σ c_i asin(b/a_i),
//!
//! with a_i = n R for each surface from each of its sides and a_i = n_x r_x, n_y r_y for the ends. Solved is
//! Θ(b) ≡ ±Δ (mod 2π) on 0 ≤ b ≤ min a_i, Δ being the angle between the ends: all roots, by cutting Θ where its slope
//! changes sign. Θ' = Σ c_i (a_i²−b²)^{−1/2} has at most as many zeros as the c_i, in the order of the a_i, change sign
//! (Descartes' rule holds for these kernels: Karlin, "Total Positivity", 1968), which is once for a ball seen from
//! outside; with more, intervals are halved until one end bounds what lies between.
//!
//! The variable is t = tan(φ/2) with b = (min a_i) sin φ, which keeps all digits at the axis and at grazing incidence.
//!
//! Roots are refined without any angle: e^{iΘ} is a product of unit complex numbers, (√(a²−b²) + i b)/a to the power c of
//! each term, and where Θ is within π of its goal, tan((Θ − goal)/2) has the same root.

/// The most terms: two for each of eight surfaces, with the ends.
const MAX_TERMS: usize = 20;
/// The most pieces on which Θ is monotone.
const MAX_PIECES: usize = 12;
/// Below this sine the ends lie on the axis: what lies there in rings has no finite light.
pub(super) const ON_AXIS: f64 = 1e-13;

/// The angle that a path sweeps around the centre.
pub(super) struct Sweep {
    /// Of each term: c and a² − high².
    terms: [(f64, f64); MAX_TERMS],
    /// Of each term: 1/a and |c|.
    turns: [(f64, u32); MAX_TERMS],
    len: usize,
    /// The sum of the c whose a is the smallest: these are φ itself.
    edge: f64,
    /// c₀ is an odd multiple of π.
    half_turn: bool,
    low: f64,
    high: f64,
}

/// Θ is followed by its turn alone where it changes by less than this, which is below π.
const NARROW: f64 = 3.0;

/// An angle by its cosine and sine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub cos: f64,
    pub sin: f64,
}

impl Unit {
    /// Turned by another angle so many times, or back.
    #[inline]
    fn by(self, other: Self, is_back: bool, times: u32) -> Self {
        let mut power = other;
        if is_back {
            power.sin = -power.sin;
        }
        let mut turned = self;
        let mut left = times;
        while left > 0 {
            if left & 1 == 1 {
                turned = turned.plus(power);
            }
            left >>= 1;
            if left > 0 {
                power = power.plus(power);
            }
        }
        turned
    }

    #[inline]
    fn plus(self, other: Self) -> Self {
        Self {
            cos: self.cos * other.cos - self.sin * other.sin,
            sin: self.sin * other.cos + self.cos * other.sin,
        }
    }
}

/// The angle Δ in [0, π] between the ends of a path: itself, π − Δ with its own digits, and its cosine and sine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Between {
    pub delta: f64,
    pub rest: f64,
    pub unit: Unit,
}

/// A root: b, on which side, and the slope of Θ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    /// Bouguer's constant, at least 0, in metres.
    pub b: f64,
    /// +1 if the path bends off towards the light, −1 if away from it.
    pub side: f64,
    /// dΘ/db.
    pub slope: f64,
}

impl Sweep {
    /// Θ with the terms `(c, a)` on the range from `low` to the smallest a, or None if this is empty or nothing.
    pub(super) fn new(terms: &[(f64, f64)], half_turn: bool, low: f64) -> Option<Self> {
        let high = terms.iter().fold(f64::INFINITY, |m, t| m.min(t.1));
        if !(high.is_finite() && low < high && terms.len() <= MAX_TERMS) {
            return None;
        }
        let mut sweep = Self {
            terms: [(0.0, 0.0); MAX_TERMS],
            turns: [(0.0, 0); MAX_TERMS],
            len: 0,
            edge: 0.0,
            half_turn,
            low: low.max(0.0),
            high,
        };
        for &(c, a) in terms {
            let d = (a - high) * (a + high);
            if d == 0.0 {
                sweep.edge += c;
            } else {
                sweep.insert((c, d), (1.0 / a, c.abs() as u32));
            }
        }
        Some(sweep)
    }

    /// Adds a term so that the a stay in order.
    #[inline]
    fn insert(&mut self, term: (f64, f64), turn: (f64, u32)) {
        let mut k = self.len;
        while k > 0 && self.terms[k - 1].1 > term.1 {
            (self.terms[k], self.turns[k]) = (self.terms[k - 1], self.turns[k - 1]);
            k -= 1;
        }
        (self.terms[k], self.turns[k]) = (term, turn);
        self.len += 1;
    }

    #[inline]
    fn terms(&self) -> &[(f64, f64)] {
        &self.terms[..self.len]
    }

    /// Θ − c₀.
    #[inline]
    fn angle(&self, t: f64) -> f64 {
        let one = 1.0 / (1.0 + t * t);
        let b = self.high * 2.0 * t * one;
        let c = self.high * (1.0 - t) * (1.0 + t) * one;
        let mut theta = if self.edge == 0.0 { 0.0 } else { self.edge * 2.0 * libm::atan(t) };
        for &(k, d) in self.terms() {
            // asin(b/a) = atan(b/√(a²−b²)), with a²−b² = (a²−high²) + (high cos φ)²
            theta += k * libm::atan(b / (d + c * c).sqrt());
        }
        theta
    }

    /// e^{i(Θ − c₀)}, and dΘ/dt.
    #[inline]
    fn turned(&self, t: f64) -> (Unit, f64) {
        let one = 1.0 / (1.0 + t * t);
        let (sin, cos) = (2.0 * t * one, (1.0 - t) * (1.0 + t) * one);
        let (b, c) = (self.high * sin, self.high * cos);
        let mut turn = Unit { cos: 1.0, sin: 0.0 };
        if self.edge != 0.0 {
            turn = turn.by(Unit { cos, sin }, self.edge < 0.0, self.edge.abs() as u32);
        }
        let mut slope = self.edge;
        for (&(k, d), &(inverse, times)) in self.terms().iter().zip(&self.turns) {
            let root = (d + c * c).sqrt();
            turn = turn.by(Unit { cos: root * inverse, sin: b * inverse }, k < 0.0, times);
            // By φ: (db/dφ)/√(a²−b²)
            slope += k * c / root;
        }
        // dφ/dt = 2/(1+t²)
        (turn, slope * 2.0 * one)
    }

    /// dΘ/dφ where high cos φ = `c`, and its derivative by c, each split into what its positive and its negative terms give.
    #[inline]
    fn slope_parts(&self, c: f64) -> [f64; 4] {
        let (mut up, mut down) = if self.edge > 0.0 { (self.edge, 0.0) } else { (0.0, -self.edge) };
        let (mut up_rate, mut down_rate) = (0.0, 0.0);
        for &(k, d) in self.terms() {
            let inverse = 1.0 / (d + c * c).sqrt();
            let part = k.abs() * inverse;
            let rate = part * d * inverse * inverse;
            if k > 0.0 {
                up += part * c;
                up_rate += rate;
            } else {
                down += part * c;
                down_rate += rate;
            }
        }
        [up, down, up_rate, down_rate]
    }

    /// How often the c change sign in the order of the a.
    #[inline]
    fn sign_changes(&self) -> usize {
        let mut last = self.edge;
        let mut count = 0;
        for &(k, _) in self.terms() {
            if last * k < 0.0 {
                count += 1;
            }
            if k != 0.0 {
                last = k;
            }
        }
        count
    }

    /// Where Θ' is zero between high cos φ = `low` and `high`, given that there it changes sign and is monotone or has no
    /// other zero.
    fn stationary(&self, mut low: f64, mut high: f64) -> f64 {
        let value = |c: f64| {
            let p = self.slope_parts(c);
            (p[0] - p[1], p[2] - p[3])
        };
        let sign = if value(high).0 > 0.0 { 1.0 } else { -1.0 };
        let mut c = 0.5 * (low + high);
        for _ in 0..60 {
            let (f, rate) = value(c);
            if f * sign > 0.0 {
                high = c;
            } else {
                low = c;
            }
            let next = c - f / rate;
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            // Θ is level here: half the digits of the place give all of those of Θ.
            if (next - c).abs() <= 1e-8 * self.high {
                return next;
            }
            c = next;
        }
        c
    }

    /// Fills `cuts` with the t that bound the pieces on which Θ is monotone, in order, and returns how many there are.
    fn cut(&self, cuts: &mut [f64; MAX_PIECES + 1]) -> usize {
        // high cos φ at the low end; t = tan(φ/2) = √((1−cos φ)/(1+cos φ))
        let widest = ((self.high - self.low) * (self.high + self.low)).sqrt();
        cuts[0] = self.low / (self.high + widest);
        let mut count = 1;
        let mut add = |c: f64| {
            if count < MAX_PIECES {
                cuts[count] = ((self.high - c) / (self.high + c)).sqrt();
                count += 1;
            }
        };
        let changes = self.sign_changes();
        if changes == 1 {
            let (a, b) = (self.slope_parts(0.0), self.slope_parts(widest));
            // Grazing, at c = 0, the smallest a decides.
            let first = if self.edge == 0.0 { a[2] - a[3] } else { a[0] - a[1] };
            if first * (b[0] - b[1]) < 0.0 {
                add(self.stationary(0.0, widest));
            }
        } else if changes > 1 {
            self.isolate(widest, &mut add);
        }
        cuts[count] = 1.0;
        count + 1
    }

    /// Calls `add` for each zero of Θ' with high cos φ from `widest` down to 0.
    fn isolate(&self, widest: f64, add: &mut impl FnMut(f64)) {
        let mut stack = [(0.0, 0.0); 48];
        stack[0] = (0.0, widest);
        let mut len = 1;
        while len > 0 {
            len -= 1;
            let (low, high) = stack[len];
            let (l, h) = (self.slope_parts(low), self.slope_parts(high));
            // The parts of the slope grow with c, those of its rate fall.
            if l[0] > h[1] || h[0] < l[1] {
                continue;
            }
            let monotone = h[2] >= l[3] || l[2] <= h[3];
            let tiny = high - low <= 1e-12 * self.high || len + 2 > stack.len();
            if monotone || tiny {
                if (l[0] - l[1]) * (h[0] - h[1]) < 0.0 {
                    add(self.stationary(low, high));
                }
                continue;
            }
            let middle = 0.5 * (low + high);
            stack[len] = (low, middle);
            stack[len + 1] = (middle, high);
            len += 2;
        }
    }

    /// The root of Θ − c₀ = `target` between `low` and `high`, where Θ is monotone and has the values `at_low`, `at_high`.
    /// `goal` is e^{i target}.
    fn root(
        &self,
        (target, goal): (f64, Unit),
        (mut low, mut high): (f64, f64),
        (mut at_low, mut at_high): (f64, f64),
    ) -> f64 {
        let rising = at_high > at_low;
        // So narrow that the turn says which way the root lies.
        while (at_high - at_low).abs() > NARROW {
            let middle = 0.5 * (low + high);
            let theta = self.angle(middle);
            if (theta > target) == rising {
                (high, at_high) = (middle, theta);
            } else {
                (low, at_low) = (middle, theta);
            }
        }
        let mut t = low + (high - low) * ((target - at_low) / (at_high - at_low)).clamp(0.0, 1.0);
        for _ in 0..80 {
            let (turn, slope) = self.turned(t);
            let off = turn.by(goal, true, 1);
            // 2 tan(x/2) = 2 sin x/(1+cos x), which is x near the root
            let f = 2.0 * off.sin / (1.0 + off.cos);
            if (off.sin > 0.0) == rising {
                high = t;
            } else {
                low = t;
            }
            let next = t - f / slope;
            // A step that stays between is Newton's; where rounding is all that is left, it ends.
            let next = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            let step = (next - t).abs();
            t = next;
            if step <= 1e-12 * t {
                break;
            }
        }
        t
    }

    /// Calls `found` for every root of Θ ≡ ±Δ (mod 2π).
    pub(super) fn solve(&self, between: &Between, mut found: impl FnMut(Root)) {
        use core::f64::consts::TAU;
        let &Between { delta, rest, unit: Unit { cos, sin } } = between;
        // Θ − c₀ ≡ ±(Δ − c₀)
        let (goal, unit) =
            if self.half_turn { (-rest, Unit { cos: -cos, sin: -sin }) } else { (delta, Unit { cos, sin }) };
        if delta.min(rest) < ON_AXIS {
            // On the axis the straight way alone counts.
            if self.low == 0.0 && goal.abs() < 1.0 {
                found(self.root_at(0.0, 1.0));
            }
            return;
        }
        let mut cuts = [0.0; MAX_PIECES + 1];
        let count = self.cut(&mut cuts);
        let mut at_low = if cuts[0] == 0.0 { 0.0 } else { self.angle(cuts[0]) };
        for k in 1..count {
            let ends = (cuts[k - 1], cuts[k]);
            let at_high = self.angle(ends.1);
            let (least, most) = (at_low.min(at_high), at_low.max(at_high));
            for side in [1.0, -1.0] {
                let unit = Unit { cos: unit.cos, sin: unit.sin * side };
                let mut target = side * goal + TAU * ((least - side * goal) / TAU).ceil();
                while target < most {
                    found(self.root_at(self.root((target, unit), ends, (at_low, at_high)), side));
                    target += TAU;
                }
            }
            at_low = at_high;
        }
    }

    fn root_at(&self, t: f64, side: f64) -> Root {
        let one = 1.0 / (1.0 + t * t);
        let c = self.high * (1.0 - t) * (1.0 + t) * one;
        // dΘ/db = (dΘ/dφ)/(high cos φ)
        let mut slope = if self.edge == 0.0 { 0.0 } else { self.edge / c };
        for &(k, d) in self.terms() {
            slope += k / (d + c * c).sqrt();
        }
        Root { b: self.high * 2.0 * t * one, side, slope }
    }
}
