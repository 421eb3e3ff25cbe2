//! What a description with a dummy state has besides: the state, its derivative, and both in the
//! structure of the model.

use crate::variables::{DERIVATIVE_NAME, STATE_NAME, Unit, state_references};

const OF_STATE: &str =
    "State without meaning, for importers that cannot integrate a unit without one";
const OF_DERIVATIVE: &str = "Its derivative: 0";

/// Writes the additions as the places for them are passed.
pub struct DummyState {
    is_fmi_3: bool,
    references: [usize; 2],
    /// Variables so far; FMI 2.0 goes by their numbers.
    count: usize,
    is_derivative_written: bool,
    is_initial_written: bool,
}

impl DummyState {
    /// For a description of this unit.
    pub fn new(unit: &Unit, is_fmi_3: bool) -> Self {
        let references = state_references(unit);
        Self {
            is_fmi_3,
            references,
            count: 0,
            is_derivative_written: false,
            is_initial_written: false,
        }
    }

    /// What comes before the element that begins here.
    pub fn before(&mut self, name: &str) -> String {
        if name == "ScalarVariable" {
            self.count += 1;
        }
        if !self.is_fmi_3 {
            return String::new();
        }
        match name {
            "InitialUnknown" => self.derivative(),
            "EventIndicator" => self.derivative() + &self.initial(),
            _ => String::new(),
        }
    }

    /// What comes before the end of an element.
    pub fn before_end(&mut self, name: &str) -> String {
        match name {
            "ModelVariables" => self.variables(),
            "InitialUnknowns" => self.unknown(),
            "ModelStructure" if self.is_fmi_3 => self.derivative() + &self.initial(),
            _ => String::new(),
        }
    }

    /// What comes behind the end of an element.
    pub fn behind(&self, name: &str) -> String {
        if name != "Outputs" {
            return String::new();
        }
        format!("\n    <Derivatives>{}</Derivatives>", self.unknown())
    }

    fn variables(&self) -> String {
        let [state, derivative] = self.references;
        let common = "causality=\"local\" variability=\"continuous\"";
        if self.is_fmi_3 {
            return format!(
                "  <Float64 name=\"{STATE_NAME}\" valueReference=\"{state}\" description=\"{OF_STATE}\" {common} initial=\"exact\" start=\"0\"/>\n    \
                 <Float64 name=\"{DERIVATIVE_NAME}\" valueReference=\"{derivative}\" description=\"{OF_DERIVATIVE}\" {common} initial=\"calculated\" \
                 derivative=\"{state}\"/>\n  "
            );
        }
        let number = self.count + 1;
        format!(
            "  <ScalarVariable name=\"{STATE_NAME}\" valueReference=\"{state}\" description=\"{OF_STATE}\" {common} initial=\"exact\"><Real \
             start=\"0\"/></ScalarVariable>\n    <ScalarVariable name=\"{DERIVATIVE_NAME}\" valueReference=\"{derivative}\" \
             description=\"{OF_DERIVATIVE}\" {common} initial=\"calculated\"><Real derivative=\"{number}\"/></ScalarVariable>\n  "
        )
    }

    /// The derivative in a list of FMI 2.0.
    fn unknown(&self) -> String {
        format!("<Unknown index=\"{}\" dependencies=\"\"/>", self.count + 2)
    }

    fn derivative(&mut self) -> String {
        if std::mem::replace(&mut self.is_derivative_written, true) {
            return String::new();
        }
        let reference = self.references[1];
        format!(
            "<ContinuousStateDerivative valueReference=\"{reference}\" dependencies=\"\"/>\n    "
        )
    }

    fn initial(&mut self) -> String {
        if std::mem::replace(&mut self.is_initial_written, true) {
            return String::new();
        }
        let reference = self.references[1];
        format!("<InitialUnknown valueReference=\"{reference}\" dependencies=\"\"/>\n    ")
    }
}
