//! Scenes with bodies.

use super::effect::Effect;
use super::effects::{At, FileError, Source};
use super::file::{Body, Contact, Joint, Names, SceneFile};
use mcp_core::dynamics::{
    self, Axis, BodyId, DynamicsError, Hold, Link, Mechanics, MoreauJean, Obstacle, Scheme,
    step_options,
};
use std::ops::Range;

/// Bodies with the effects the scene names.
pub(crate) fn stepper(
    scene: &SceneFile,
    effects: &[Effect],
    source: &Source<'_>,
) -> Result<MoreauJean, FileError> {
    let on = |effect| effects.contains(&effect);
    let mut build = Build { system: Mechanics::new(), bodies: Names::new(), source };
    for body in &scene.body {
        build.body(body)?;
    }
    if let (true, Some(gravity)) = (on(Effect::Gravity), &scene.gravity) {
        let added = build.system.add_gravity(gravity.acceleration);
        added.map_err(|error| source.refused(error))?;
    }
    if on(Effect::Spring) {
        for spring in &scene.spring {
            let s = spring.get_ref();
            let ends = (&s.body, s.to.as_ref(), &s.along);
            let link = build.link("spring", ends, *s.stiffness.get_ref(), s.rest)?;
            let added = build.system.add_spring(link);
            build.check(added, "spring.stiffness", s.stiffness.span())?;
        }
    }
    if on(Effect::Damper) {
        for damper in &scene.damper {
            let d = damper.get_ref();
            let ends = (&d.body, d.to.as_ref(), &d.along);
            let link = build.link("damper", ends, *d.damping.get_ref(), 0.0)?;
            let added = build.system.add_damper(link);
            build.check(added, "damper.damping", d.damping.span())?;
        }
    }
    if on(Effect::Drag) {
        for drag in &scene.drag {
            let drag = drag.get_ref();
            let body = build.find("drag.body", &drag.body)?;
            let added = build.system.add_drag(body, *drag.coefficient.get_ref());
            build.check(added, "drag.coefficient", drag.coefficient.span())?;
        }
    }
    if on(Effect::Contact) {
        for contact in &scene.contact {
            build.contact(contact, on(Effect::Restitution), on(Effect::Friction))?;
        }
    }
    if on(Effect::Joint) {
        for joint in &scene.joint {
            build.joint(joint)?;
        }
    }
    let time = &scene.time;
    let mut scheme = Scheme::new(*time.step.get_ref());
    for (given, place) in [(&time.theta, &mut scheme.theta), (&time.gamma, &mut scheme.gamma)] {
        *place = given.as_ref().map_or(*place, |given| *given.get_ref());
    }
    let stepper = MoreauJean::new(build.system, scheme, &step_options());
    stepper.map_err(|error| source.refused(error))
}

/// A system that grows.
struct Build<'a> {
    system: Mechanics,
    bodies: Names<BodyId>,
    source: &'a Source<'a>,
}

impl Build<'_> {
    /// What was added, or why not, at its place.
    fn check<T>(
        &self,
        added: Result<T, DynamicsError>,
        key: &str,
        at: Range<usize>,
    ) -> Result<T, FileError> {
        added.map_err(|error| self.source.error(at, key, error.to_string()))
    }

    fn find(&self, key: &str, name: &At<String>) -> Result<BodyId, FileError> {
        let missing = || {
            let names: Vec<&str> = self.bodies.keys().map(String::as_str).collect();
            let message = format!("no body is called `{}`: {}", name.get_ref(), names.join(", "));
            self.source.error(name.span(), key, message)
        };
        self.bodies.get(name.get_ref()).copied().ok_or_else(missing)
    }

    fn body(&mut self, entry: &At<Body>) -> Result<(), FileError> {
        let body = entry.get_ref();
        let Some(mass) = &body.mass else {
            let message = format!("{} has no mass", body.name);
            return Err(self.source.error(entry.span(), "body.mass", message));
        };
        let number = |given: &Option<At<f64>>| given.as_ref().map_or(0.0, |given| *given.get_ref());
        let mut planar =
            dynamics::Body::new(&body.name, *mass.get_ref()).radius(number(&body.radius));
        for (axis, motion) in [(Axis::X, body.x), (Axis::Y, body.y)] {
            if let Some([position, velocity]) = motion {
                planar = planar.moving(axis, position, velocity);
            }
        }
        // The place of the first number that may be refused.
        let at = |given: &Option<At<f64>>| given.as_ref().map(At::span);
        let mut place = ("body.mass", mass.span());
        if *mass.get_ref() > 0.0 {
            let radius = at(&body.radius).filter(|_| number(&body.radius) < 0.0);
            place = radius.map_or(("body", entry.span()), |at| ("body.radius", at));
        }
        if let Some(angle) = &body.angle {
            let Some(inertia) = &body.inertia else {
                let message = format!("{} turns, but has no inertia", body.name);
                return Err(self.source.error(angle.span(), "body.inertia", message));
            };
            let [position, velocity] = *angle.get_ref();
            planar = planar.turning(*inertia.get_ref(), position, velocity);
        }
        let added = self.system.add_body(&planar);
        let id = self.check(added, place.0, place.1)?;
        if self.bodies.insert(body.name.clone(), id).is_some() {
            let message = format!("two bodies are called `{}`", body.name);
            return Err(self.source.error(entry.span(), "body.name", message));
        }
        Ok(())
    }

    fn link(
        &self,
        effect: &str,
        (body, to, along): (&At<String>, Option<&At<String>>, &At<String>),
        coefficient: f64,
        rest: f64,
    ) -> Result<Link, FileError> {
        let axes = [Axis::X, Axis::Y, Axis::Angle];
        let found = axes.into_iter().find(|axis| axis.name() == along.get_ref());
        let Some(axis) = found else {
            let message = format!("is `{}`, but must be x, y or angle", along.get_ref());
            return Err(self.source.error(along.span(), format!("{effect}.along"), message));
        };
        let body = self.find(&format!("{effect}.body"), body)?;
        let to = to.map(|to| self.find(&format!("{effect}.to"), to)).transpose()?;
        Ok(Link { axis, body, to, coefficient, rest })
    }

    fn contact(
        &mut self,
        entry: &At<Contact>,
        restitution: bool,
        friction: bool,
    ) -> Result<(), FileError> {
        let given = entry.get_ref();
        let with = match &given.with {
            Some(other) => Obstacle::Body(self.find("contact.with", other)?),
            None => Obstacle::Plane { normal: given.normal, offset: given.offset },
        };
        let body = self.find("contact.body", &given.body)?;
        let mut contact = dynamics::Contact::new(&given.name, body, with);
        let mut place = ("contact", entry.span());
        if let (true, Some(e)) = (restitution, &given.restitution) {
            contact = contact.restitution(*e.get_ref());
            if !(0.0..=1.0).contains(e.get_ref()) {
                place = ("contact.restitution", e.span());
            }
        }
        if let (true, Some(mu)) = (friction, &given.friction) {
            contact = contact.friction(*mu.get_ref());
            if !(*mu.get_ref() >= 0.0) {
                place = ("contact.friction", mu.span());
            }
        }
        let added = self.system.add_contact(contact);
        self.check(added, place.0, place.1)
    }

    fn joint(&mut self, entry: &At<Joint>) -> Result<(), FileError> {
        let given = entry.get_ref();
        let hold = match (given.rail, given.anchor, &given.with) {
            (Some(normal), None, None) => Hold::Rail(normal),
            (None, Some(point), None) => Hold::Anchor(point),
            (None, None, Some(other)) => Hold::Body(self.find("joint.with", other)?),
            _ => {
                let message = format!("{} needs one of rail, anchor, with", given.name);
                return Err(self.source.error(entry.span(), "joint", message));
            }
        };
        let body = self.find("joint.body", &given.body)?;
        let added = self.system.add_joint(dynamics::Joint::new(&given.name, body, hold));
        self.check(added, "joint", entry.span())
    }
}
