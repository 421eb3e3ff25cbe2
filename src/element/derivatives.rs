//! Derivatives of the outputs by the inputs, exact but for rounding.
//!
//! Searches (contacts, edges of zones, the height that carries a load) go by plain numbers as in an
//! evaluation. What they found fulfils equations, and moves as these tell; all the rest is
//! evaluated once more with dual numbers ([`Dual`]). The derivative belongs to the force as it is
//! computed, element by element of the tractions. At a kink, such as the end of an adhesion area
//! that passes from one element to the next, it is that of one side.

use super::contact::models::Models;
use super::contact::rail_friction::RailFriction;
use super::derivative_memory::{DIRECTIONS, DerivativeMemory};
use super::input::{HEIGHT, INPUT_NAMES, INPUTS, Input, LOAD};
use super::output::{Output, Wrench};
use super::parameters::foundation::FoundationModel;
use super::parameters::{NormalModel, VerticalMode};
use super::rail::moving_contact::{Kink, MovingNumber};
use super::rail::rail_contact::RailContact;
use super::vertical_load::is_carried;
use super::wheel_on_rails::Element;
use crate::error::ContactError;
use crate::math::dual::Dual;
use crate::tangential::TangentialModel;

/// What gives bodies waves.
pub(super) const WAVES: &str = "wheel.flat, wheel.out_of_round or rail[k].corrugation";

impl Element {
    /// The derivative of the outputs in the direction `direction`, all of whose numbers are rates
    /// of the inputs: with the Jacobian J of the outputs, J · direction, as the rates of the
    /// outputs in `rates`. Counts and wear have none.
    ///
    /// In load mode the height follows the load, and the rate of `wheel.z` is without effect. The
    /// first call allocates. The element is left as it was.
    ///
    /// ```
    /// use wheelrail::element::{Element, Input, Output, Parameters};
    ///
    /// let mut input = Input::default();
    /// let mut element = Element::new(&Parameters::default(), &input, &[])?;
    /// input.wheel.position[2] = element.nominal_wheel_z() + 1e-4;
    /// // Stiffness of the contact: the change of the vertical force with the height.
    /// let mut down = Input::at_rest();
    /// down.wheel.position[2] = 1.0;
    /// let mut rates = Output::default();
    /// element.directional_derivative(&input, &down, &mut rates)?;
    /// assert!(rates.wheel.force[2] < -5e8);
    /// # Ok::<(), wheelrail::error::ContactError>(())
    /// ```
    ///
    /// # Errors
    /// The input at fault, by its FMU name, or [`ContactError::NoDerivative`]; `rates` is then as
    /// before.
    pub fn directional_derivative(
        &mut self,
        input: &Input,
        direction: &Input,
        rates: &mut Output,
    ) -> Result<(), ContactError> {
        let input = self.admitted(input)?;
        self.check_models()?;
        let side = self.side;
        let direction = self.turning(*direction);
        let mut directions = [side.mirror(direction).to_array()];
        let followed = self.carried_at(&input).and_then(|at| {
            let ways = self.give_way(&at, &mut directions)?;
            self.with_memory(|element, DerivativeMemory { one, one_output, .. }| {
                element.follow(&at, &directions, one, one_output, |_, mut found| {
                    found.foundation.deflection = ways[0];
                    *rates = side.mirror(found);
                })
            })
        });
        followed.map_err(at_this_input)
    }

    /// All derivatives of the outputs: `columns` gets one entry for each input, in the order of
    /// [`INPUT_NAMES`](super::input::INPUT_NAMES), with the derivatives by it as the rates of the
    /// outputs. Cheaper than as many calls of
    /// [`directional_derivative`](Self::directional_derivative).
    ///
    /// # Errors
    /// As [`directional_derivative`](Self::directional_derivative); `columns` are then as before or
    /// hold a part.
    pub fn jacobian(
        &mut self,
        input: &Input,
        columns: &mut Vec<Output>,
    ) -> Result<(), ContactError> {
        let input = self.admitted(input)?;
        self.check_models()?;
        let followed = self.carried_at(&input).and_then(|at| self.all_columns(&at, columns));
        followed.map_err(at_this_input)
    }

    /// The derivatives of the force and the moment on the wheel in each of the `directions`, at most
    /// [`DIRECTIONS`], of an element whose heights are given; one sweep for all of them.
    ///
    /// # Errors
    /// As [`directional_derivative`](Self::directional_derivative); `rates` hold a part then.
    pub(super) fn wheel_rates(
        &mut self,
        input: &Input,
        directions: &[Input],
        rates: &mut [Wrench],
    ) -> Result<(), ContactError> {
        let input = self.admitted(input)?;
        self.check_models()?;
        let side = self.side;
        let mut ways = [[0.0; INPUTS]; DIRECTIONS];
        for (way, direction) in ways.iter_mut().zip(directions) {
            let direction = self.turning(*direction);
            *way = side.mirror(direction).to_array();
        }
        let ways = &mut ways[..directions.len()];
        let followed = self.carried_at(&input).and_then(|at| {
            self.give_way(&at, ways)?;
            self.with_memory(|element, DerivativeMemory { all, all_output, .. }| {
                element.follow(&at, ways, all, all_output, |n, found| {
                    rates[n] = side.mirror(found).wheel;
                })
            })
        });
        followed.map_err(at_this_input)
    }

    /// Lends the memory beside the element.
    fn with_memory<R>(&mut self, work: impl FnOnce(&mut Self, &mut DerivativeMemory) -> R) -> R {
        let mut memory = self.memory.take().unwrap_or_else(|| self.derivative_memory());
        let done = work(self, &mut memory);
        self.memory = Some(memory);
        done
    }

    /// Hands the rates of the lateral and vertical force on the rails of a right wheel in each of
    /// the `directions` to `each`, without what the foundation gives way; returns the forces.
    ///
    /// # Errors
    /// What has no derivative there.
    pub(super) fn rail_rates(
        &mut self,
        at: &(Input, Height),
        directions: &[[f64; INPUTS]],
        mut each: impl FnMut(usize, [f64; 2]),
    ) -> Result<[f64; 2], Kink> {
        if self.check_models().is_err() {
            return Err("the models have no derivatives");
        }
        let found = |n: usize, rates: Output| {
            let [_, y, z] = rates.wheel.force;
            each(n, [-y, -z]);
        };
        self.with_memory(|element, memory| {
            let DerivativeMemory { one, one_output, all, all_output } = memory;
            let room = if at.1 == Height::Given { 2 } else { 1 };
            let [_, y, z] = if directions.len() <= room {
                element.follow(at, directions, one, one_output, found)?;
                one_output.wheel.force.map(|force| force.value)
            } else {
                element.follow(at, directions, all, all_output, found)?;
                all_output.wheel.force.map(|force| force.value)
            };
            Ok([-y, -z])
        })
    }

    /// Sizes the memory for derivatives, where the models have them, so that the first of them
    /// allocates nothing.
    pub(crate) fn reserve_derivatives(&mut self) {
        if self.memory.is_none() && self.check_models().is_ok() {
            self.memory = Some(self.derivative_memory());
        }
    }

    /// Most rows of an outline of a rail that varies along the track, if there is one.
    pub(super) fn outline_rows(&self) -> Option<usize> {
        let rails = self.rails.iter().flatten();
        rails.filter_map(|rail| Some(rail.rail.variation()?.most_knots())).max()
    }

    fn derivative_memory(&self) -> Box<DerivativeMemory> {
        let rows = self.outline_rows();
        Box::new(DerivativeMemory {
            one: self.models.in_other_numbers(rows),
            one_output: Output::default(),
            all: self.models.in_other_numbers(rows),
            all_output: Output::default(),
        })
    }

    /// Whether the models have derivatives.
    pub(super) fn check_models(&self) -> Result<(), ContactError> {
        let refuse = |name, reason| Err(ContactError::NoDerivative { name: Some(name), reason });
        if self.models.normal == NormalModel::BoundaryElement {
            return refuse(
                "normal.model = boundary_element",
                "they are there for real-time models",
            );
        }
        if self.models.tangential.model() == TangentialModel::BoundaryElement {
            let reason = "they are there for real-time models";
            return refuse("tangential.model = boundary_element", reason);
        }
        if self.models.uneven.is_some() && self.models.normal != NormalModel::Strips {
            return refuse(WAVES, "over waves they are there for normal.model = strips");
        }
        if self.rails.iter().flatten().any(RailContact::is_corrugated_roller) {
            let name = "rail[k].corrugation on rail[k].roller_radius";
            return refuse(name, "they are there for rollers that are even around");
        }
        if self.rails.iter().flatten().any(RailContact::wheel_varies) {
            let reason = "they are there for wheels that are the same all around";
            return refuse("wheel.profile with sections around", reason);
        }
        Ok(())
    }

    /// The columns of [`jacobian`](Self::jacobian).
    fn all_columns(&mut self, at: &(Input, Height), columns: &mut Vec<Output>) -> Result<(), Kink> {
        let side = self.side;
        columns.clear();
        columns.resize(INPUTS, Output::default());
        let most = if at.1 == Height::Given { DIRECTIONS } else { DIRECTIONS - 1 };
        let mut i = 0;
        while i < INPUTS {
            let (mut directions, mut places) = ([[0.0; INPUTS]; DIRECTIONS], [0; DIRECTIONS]);
            let mut count = 0;
            while i < INPUTS && count < most {
                if self.has_effect(i) {
                    let mut unit = [0.0; INPUTS];
                    unit[i] = 1.0;
                    let unit = self.turning(Input::from_array(unit));
                    let unit = side.mirror(unit);
                    (directions[count], places[count]) = (unit.to_array(), i);
                    count += 1;
                }
                i += 1;
            }
            let directions = &mut directions[..count];
            let ways = self.give_way(at, directions)?;
            self.with_memory(|element, DerivativeMemory { all, all_output, .. }| {
                element.follow(at, directions, all, all_output, |n, mut found| {
                    found.foundation.deflection = ways[n];
                    columns[places[n]] = side.mirror(found);
                })
            })?;
        }
        Ok(())
    }

    /// Hands the rates of the outputs of a right wheel in each of the `directions` to `each`: at
    /// most N, and where the height follows the load or the rails at most N - 1.
    fn follow<const N: usize>(
        &mut self,
        at: &(Input, Height),
        directions: &[[f64; INPUTS]],
        models: &mut Models<Dual<N>>,
        output: &mut Output<Dual<N>>,
        mut each: impl FnMut(usize, Output),
    ) -> Result<(), Kink> {
        let (input, height) = at;
        let values = input.to_array();
        let follows = *height != Height::Given;
        let input = Input::from_array(std::array::from_fn(|i| {
            let mut number = Dual::from(values[i]);
            for (slope, direction) in number.slopes.iter_mut().zip(directions) {
                *slope = if follows && i == HEIGHT { 0.0 } else { direction[i] };
            }
            if follows && i == HEIGHT {
                number.slopes[N - 1] = 1.0;
            }
            number
        }));
        let mut deepest = None;
        if *height == Height::Touching {
            *output = Output::default();
            deepest = self.deepest(&input, models)?;
        } else {
            self.moving_forces(&input, models, output)?;
        }
        for (n, direction) in directions.iter().enumerate() {
            // The rate of the height, so that the force goes with the load, or the contact stays
            // one point.
            let down = match (height, deepest) {
                (Height::Given, _) => 0.0,
                (Height::Loaded, _) => {
                    let force = output.wheel.force[2].slopes;
                    -(direction[LOAD] + force[n]) / force[N - 1]
                }
                (Height::Touching, Some(Dual { slopes, .. })) => -slopes[n] / slopes[N - 1],
                (Height::Touching, None) => direction[HEIGHT],
            };
            let mut rates =
                output.each(|x| x.slopes[n] + if follows { down * x.slopes[N - 1] } else { 0.0 });
            if follows {
                rates.wheel_z = down;
            }
            if !is_finite(&rates) {
                return Err("a force grows without bound there");
            }
            each(n, rates);
        }
        Ok(())
    }

    /// Whether anything can depend on input number `i`: a rail that is not there has no effect, nor
    /// has the station of bodies that are even and have the same friction all along the track, nor
    /// how a straight rail or a wheel without waves turns, nor a load where the height is given, nor
    /// friction that is told otherwise.
    fn has_effect(&self, i: usize) -> bool {
        let has = |of: fn(&RailFriction) -> bool| {
            self.rails.iter().flatten().filter_map(|rail| rail.friction.as_ref()).any(of)
        };
        let mut rails = self.rails.iter().flatten();
        let varies = rails.any(|rail| rail.rail.varies_along_track());
        let is_roller =
            |k: usize| self.rails[k].as_ref().is_some_and(|rail| rail.rail.roller_radius() > 0.0);
        match INPUT_NAMES[i] {
            "wheel.pitch" => self.rails.iter().flatten().any(|rail| rail.rail.wheel_has_waves()),
            "track.s" => has(RailFriction::has_stations) || varies,
            "friction.coefficient" => !has(|_| true),
            "friction.tread.coefficient" | "friction.gauge_face.coefficient" => {
                has(RailFriction::has_regions)
            }
            "wheel.load" => self.vertical_mode == VerticalMode::Load,
            "rail[1].pitch_rate" => is_roller(0),
            "rail[2].pitch_rate" => is_roller(1),
            name if name.starts_with("rail[1]") => self.rails[0].is_some(),
            name if name.starts_with("rail[2]") => self.rails[1].is_some(),
            _ => true,
        }
    }

    /// The input of a right side, with rails where they are on their foundation and at the height
    /// that carries its load if that is given.
    pub(super) fn carried_at(&mut self, input: &Input) -> Result<(Input, Height), Kink> {
        let mut input = self.side.mirror(*input);
        let is_given = self.vertical_mode == VerticalMode::Penetration;
        if is_given && self.foundation.model == FoundationModel::Rigid {
            return Ok((input, Height::Given));
        }
        let mut output = Output::default();
        let load = input.wheel_load;
        // No evaluation was asked for.
        let work = self.work;
        self.respond(&mut input, &mut output);
        self.work = work;
        if is_given {
            return Ok((input, Height::Given));
        }
        if load <= 0.0 {
            return Ok((input, Height::Touching));
        }
        if !is_carried(load, -output.wheel.force[2]) {
            return Err("the rails carry wheel.load at no height near");
        }
        Ok((input, Height::Loaded))
    }

    /// Forces, patches and height with derivatives for the `input` of a right side.
    pub(super) fn moving_forces<T: MovingNumber>(
        &mut self,
        input: &Input<T>,
        models: &mut Models<T>,
        output: &mut Output<T>,
    ) -> Result<(), Kink> {
        *output = Output::default();
        models.patches.clear();
        for (k, rail) in self.rails.iter_mut().enumerate() {
            if let Some(rail) = rail {
                rail.move_along(k, input, &mut self.models, models, output)?;
            }
        }
        output.report(input, &mut models.patches);
        Ok(())
    }

    /// Deepest penetration with any rail, if the wheel touches one.
    pub(super) fn deepest<T: MovingNumber>(
        &mut self,
        input: &Input<T>,
        models: &mut Models<T>,
    ) -> Result<Option<T>, Kink> {
        let mut deepest = None::<T>;
        for (k, rail) in self.rails.iter_mut().enumerate() {
            let Some(rail) = rail else { continue };
            if let Some(found) = rail.moving_penetration(k, input, models)?
                && deepest.is_none_or(|deepest| found > deepest)
            {
                deepest = Some(found);
            }
        }
        Ok(deepest)
    }
}

/// What the height of the wheel follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Height {
    /// The input.
    Given,
    /// The load.
    Loaded,
    /// The height of first touch, where there is no load.
    Touching,
}

/// Whether all rates are finite.
fn is_finite(rates: &Output) -> bool {
    let mut sum = 0.0;
    // Zero times anything that is not finite is not a number.
    rates.each(|rate| sum += 0.0 * rate);
    sum == 0.0
}

#[cold]
pub(super) fn at_this_input(reason: Kink) -> ContactError {
    ContactError::NoDerivative { name: None, reason }
}
