//! Scenes with bodies.

use super::effect::Effect;
use super::effects::{At, FileError, Source};
use super::file::{Body, Contact, Joint, Names, SceneFile, or};
use super::place::Entry;
use mcp_core::dynamics::{
    self, Axis, BodyId, Hold, Link, Mechanics, MoreauJean, Obstacle, Scheme, step_options,
};

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
        let g = &gravity.acceleration;
        let entry = Entry::new(source, "gravity", g.span()).has("acceleration", "acceleration", g);
        build.system.add_gravity(*g.get_ref()).map_err(|error| entry.fault(&error))?;
    }
    if on(Effect::Spring) {
        for spring in &scene.spring {
            let s = spring.get_ref();
            let ends = (&s.body, s.to.as_ref(), &s.along);
            let entry = Entry::new(source, "spring", spring.span())
                .has("stiffness", "stiffness", &s.stiffness)
                .may("rest", "rest", s.rest.as_ref());
            let entry = with_ends(entry, ends);
            let (stiffness, rest) = (*s.stiffness.get_ref(), or(s.rest.as_ref(), 0.0));
            let link = build.link("spring", ends, stiffness, rest)?;
            build.system.add_spring(link).map_err(|error| entry.fault(&error))?;
        }
    }
    if on(Effect::Damper) {
        for damper in &scene.damper {
            let d = damper.get_ref();
            let ends = (&d.body, d.to.as_ref(), &d.along);
            let entry = Entry::new(source, "damper", damper.span());
            let entry = with_ends(entry.has("damping", "damping", &d.damping), ends);
            let link = build.link("damper", ends, *d.damping.get_ref(), 0.0)?;
            build.system.add_damper(link).map_err(|error| entry.fault(&error))?;
        }
    }
    if on(Effect::Drag) {
        for drag in &scene.drag {
            let (at, drag) = (drag.span(), drag.get_ref());
            let body = build.find("drag.body", &drag.body)?;
            let entry =
                Entry::new(source, "drag", at).has("drag", "coefficient", &drag.coefficient);
            let added = build.system.add_drag(body, *drag.coefficient.get_ref());
            added.map_err(|error| entry.fault(&error))?;
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
    let defaults = Scheme::new(*time.step.get_ref());
    let scheme = Scheme {
        theta: or(time.theta.as_ref(), defaults.theta),
        gamma: or(time.gamma.as_ref(), defaults.gamma),
        ..defaults
    };
    let stepper = MoreauJean::new(build.system, scheme, &step_options());
    stepper.map_err(|error| time.entry(source).fault(&error))
}

/// The bodies of a spring or damper and its axis.
type Ends<'a> = (&'a At<String>, Option<&'a At<String>>, &'a At<String>);

fn with_ends<'a>(entry: Entry<'a>, (_, to, along): Ends<'_>) -> Entry<'a> {
    entry.may("other", "to", to).has("coordinate", "along", along)
}

/// A system that grows.
struct Build<'a> {
    system: Mechanics,
    bodies: Names<BodyId>,
    source: &'a Source<'a>,
}

impl Build<'_> {
    fn find(&self, key: &str, name: &At<String>) -> Result<BodyId, FileError> {
        let missing = || {
            let names: Vec<&str> = self.bodies.keys().map(String::as_str).collect();
            let message = format!("no body is called `{}`: {}", name.get_ref(), names.join(", "));
            self.source.error(name.span(), key, message)
        };
        self.bodies.get(name.get_ref()).copied().ok_or_else(missing)
    }

    fn body(&mut self, given: &At<Body>) -> Result<(), FileError> {
        let (at, body) = (given.span(), given.get_ref());
        let name = body.name.get_ref();
        let Some(mass) = &body.mass else {
            return Err(self.source.error(at, "body.mass", format!("{name} has no mass")));
        };
        let mut planar = dynamics::Body::new(name, *mass.get_ref());
        planar = planar.radius(or(body.radius.as_ref(), 0.0));
        for (axis, motion) in [(Axis::X, &body.x), (Axis::Y, &body.y)] {
            if let Some(motion) = motion {
                let [position, velocity] = motion.get_ref().0;
                planar = planar.moving(axis, position, velocity);
            }
        }
        if let Some(angle) = &body.angle {
            let Some(inertia) = &body.inertia else {
                let message = format!("{name} turns, but has no inertia");
                return Err(self.source.error(angle.span(), "body.inertia", message));
            };
            let [position, velocity] = angle.get_ref().0;
            planar = planar.turning(*inertia.get_ref(), position, velocity);
        }
        let entry = Entry::new(self.source, "body", at)
            .has("name", "name", &body.name)
            .has("mass", "mass", mass)
            .may("radius", "radius", body.radius.as_ref())
            .may("inertia", "inertia", body.inertia.as_ref())
            .may("x", "x", body.x.as_ref())
            .may("x velocity", "x", body.x.as_ref())
            .may("y", "y", body.y.as_ref())
            .may("y velocity", "y", body.y.as_ref())
            .may("angle", "angle", body.angle.as_ref())
            .may("angular velocity", "angle", body.angle.as_ref());
        let id = self.system.add_body(&planar).map_err(|error| entry.fault(&error))?;
        self.bodies.insert(name.clone(), id);
        Ok(())
    }

    fn link(
        &self,
        effect: &str,
        (body, to, along): Ends<'_>,
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
        let (at, given) = (entry.span(), entry.get_ref());
        let with = match &given.with {
            Some(other) => Obstacle::Body(self.find("contact.with", other)?),
            None => Obstacle::Plane {
                normal: given.normal.as_ref().map_or([0.0, 1.0], |normal| normal.get_ref().0),
                offset: or(given.offset.as_ref(), 0.0),
            },
        };
        let body = self.find("contact.body", &given.body)?;
        let mut contact = dynamics::Contact::new(given.name.get_ref(), body, with);
        if let (true, Some(e)) = (restitution, &given.restitution) {
            contact = contact.restitution(*e.get_ref());
        }
        if let (true, Some(mu)) = (friction, &given.friction) {
            contact = contact.friction(*mu.get_ref());
        }
        let entry = Entry::new(self.source, "contact", at)
            .has("name", "name", &given.name)
            .may("other", "with", given.with.as_ref())
            .may("normal", "normal", given.normal.as_ref())
            .may("offset", "offset", given.offset.as_ref())
            .may("restitution", "restitution", given.restitution.as_ref())
            .may("friction", "friction", given.friction.as_ref())
            .may("tangent", "friction", given.friction.as_ref());
        self.system.add_contact(contact).map_err(|error| entry.fault(&error))
    }

    fn joint(&mut self, entry: &At<Joint>) -> Result<(), FileError> {
        let (at, given) = (entry.span(), entry.get_ref());
        let name = given.name.get_ref();
        let hold = match (&given.rail, &given.anchor, &given.with) {
            (Some(normal), None, None) => Hold::Rail(normal.get_ref().0),
            (None, Some(point), None) => Hold::Anchor(point.get_ref().0),
            (None, None, Some(other)) => Hold::Body(self.find("joint.with", other)?),
            _ => {
                let message = format!("{name} needs one of rail, anchor, with");
                return Err(self.source.error(at, "joint", message));
            }
        };
        let body = self.find("joint.body", &given.body)?;
        let entry = Entry::new(self.source, "joint", at)
            .has("name", "name", &given.name)
            .may("other", "with", given.with.as_ref())
            .may("normal", "rail", given.rail.as_ref())
            .may("anchor", "anchor", given.anchor.as_ref());
        let added = self.system.add_joint(dynamics::Joint::new(name, body, hold));
        added.map_err(|error| entry.fault(&error))
    }
}
