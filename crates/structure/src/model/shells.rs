//! Shells and their sections: CQUAD4 (CQUADR), CTRIA3, CTRIAR, CQUAD8 and CTRIA6 with PSHELL, PCOMP and PCOMPG.

use super::build::{Builder, loss_of, present, undefined};
use super::registry::ElementCard;
use crate::cell_shape::CellShape;
use crate::element::Element;
use crate::laminate::ShellSection;
use crate::plane_material::PlaneMaterial;
use crate::shell::{CurvedPlace, CurvedShell, SectionAxis, Shell};
use nalgebra::{Matrix2, Matrix3, Point3, Vector3};
use nastran::{BulkData, InputError, LaminateOption, Mat2, MaterialDirection, Pshell, ShellElement, Span};
use std::sync::Arc;

/// Length of a unit vector's projection that is round-off.
const ROUND_OFF: f64 = 1e-12;

impl ElementCard for ShellElement {
    fn element(&self, builder: &mut Builder) -> Result<Arc<dyn Element>, InputError> {
        let name = match (self.grids.len(), self.midsides.is_empty()) {
            (4, true) => "CQUAD4",
            (4, false) => "CQUAD8",
            (_, true) => "CTRIA3",
            (_, false) => "CTRIA6",
        };
        let user = format!("{name} {}", self.id);
        let section = if let Some(known) = builder.sections.get(&self.property) {
            Arc::clone(known)
        } else {
            let made = Arc::new(builder.section(self, &user)?);
            builder.sections.insert(self.property, Arc::clone(&made));
            made
        };
        let ratios = builder.thickness_ratios(self, &user)?;
        if !self.midsides.is_empty() {
            return Ok(Arc::new(builder.curved(self, section, &user)?));
        }
        let nodes = builder.nodes_of(&self.grids, &user, &self.span)?;
        let points: Vec<Point3<f64>> = nodes.iter().map(|node| builder.nodes[*node].point).collect();
        let angle = builder.angle(self, &points, &user)?;
        let mut shell = Shell::new(self.id, nodes, &points, self.offset, section, angle, &self.span)?;
        if let Some(ratios) = ratios {
            shell = shell.with_thickness(ratios);
        }
        if let Some(nastran) = &builder.nastran {
            shell = nastran.shell(shell);
        }
        let normal = shell.axes().row(2).transpose();
        // Nastran ties them all the same.
        if builder.nastran.is_none() && shell.nodes().iter().all(|node| builder.is_held(*node, &normal)) {
            shell = shell.with_drilling_tie(0.0);
        }
        Ok(Arc::new(if self.is_r { shell.with_drilling() } else { shell }))
    }

    fn property(&self) -> Option<u32> {
        Some(self.property)
    }

    fn cell(&self) -> Option<(CellShape, Vec<u32>)> {
        let shape = if self.grids.len() == 3 { CellShape::Triangle } else { CellShape::Quadrilateral };
        Some((shape, self.grids.clone()))
    }

    /// Of a plate that of its membrane's material (QRG, PSHELL), of a laminate its own.
    fn loss_factor(&self, bulk: &BulkData) -> f64 {
        if let Some(plate) = bulk.shell_properties.get(&self.property) {
            return loss_of(bulk, plate.membrane.or(plate.bending));
        }
        bulk.loss_factors.laminates.get(&self.property).copied().unwrap_or(0.0)
    }
}

impl Builder<'_> {
    /// Thicknesses at the corners in units of the property's, where they differ.
    fn thickness_ratios(&self, card: &ShellElement, user: &str) -> Result<Option<Vec<f64>>, InputError> {
        let plain = self.bulk.shell_properties.get(&card.property).map(|property| property.thickness);
        let laminate = self.bulk.laminates.get(&card.property).map(|laminate| {
            let listed: f64 = laminate.plies.iter().map(|ply| ply.thickness).sum();
            if laminate.option == LaminateOption::Symmetric { 2.0 * listed } else { listed }
        });
        let ratios = plain.or(laminate).and_then(|thickness| card.thickness.ratios(thickness));
        let blamed = if laminate.is_some() {
            "a laminate has"
        } else if !card.midsides.is_empty() {
            "a shell with grids on its sides has"
        } else {
            return Ok(ratios);
        };
        if ratios.is_none() {
            return Ok(None);
        }
        let message =
            format!("{user}: its corner thicknesses are not its property's, which {blamed} everywhere");
        Err(InputError::at(&card.span, message)
            .with_help("leave the corner thicknesses empty and use a property for each thickness"))
    }

    fn curved(
        &self,
        card: &ShellElement,
        section: Arc<ShellSection>,
        user: &str,
    ) -> Result<CurvedShell, InputError> {
        let (sides, midsides) = present(&card.midsides);
        let grids: Vec<u32> = card.grids.iter().copied().chain(midsides).collect();
        let nodes = self.nodes_of(&grids, user, &card.span)?;
        let points: Vec<Point3<f64>> = nodes.iter().map(|node| self.nodes[*node].point).collect();
        let axis = match card.direction {
            MaterialDirection::AngleDeg(angle) => SectionAxis::Angle(angle.to_radians()),
            MaterialDirection::System(system) => {
                let middle =
                    points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / (points.len() as f64);
                let axes = self.frames.axes_at_point(system, &Point3::from(middle), &card.span)?;
                SectionAxis::Along(axes.column(0).into_owned())
            }
        };
        let place = CurvedPlace { nodes, points, sides, offset_m: card.offset };
        let shell = CurvedShell::new(card.id, place, section, axis, &card.span)?;
        let mut grids = shell.nodes().iter().zip(shell.normals());
        let are_held = grids.all(|(node, normal)| self.is_held(*node, normal));
        Ok(if are_held { shell.without_drilling_tie() } else { shell })
    }

    /// From the element's x axis to the material's, rad.
    pub(super) fn angle(
        &self,
        card: &ShellElement,
        points: &[Point3<f64>],
        user: &str,
    ) -> Result<f64, InputError> {
        let system = match card.direction {
            MaterialDirection::AngleDeg(angle) => return Ok(angle.to_radians()),
            MaterialDirection::System(system) => system,
        };
        // A degenerate element is refused with its own message where it is made.
        let Some(axes) = Shell::axes_of(points) else { return Ok(0.0) };
        let middle = points.iter().map(|point| point.coords).sum::<Vector3<f64>>() / (points.len() as f64);
        let x = axes * self.frames.axes_at_point(system, &Point3::from(middle), &card.span)?.column(0);
        // The projection is taken as the deck's digits give it, however short, as Nastran does (FreeDLM's ribs, 6e-8).
        let projected = x.x.hypot(x.y);
        if (ROUND_OFF..1e-6).contains(&projected) {
            tracing::warn!(
                "{user}: the x axis of system {system} (MCID) is almost normal to the element: its projection, {projected:.1e}, is the material's direction"
            );
        }
        if projected < ROUND_OFF {
            let message = format!("{user}: the x axis of system {system} (MCID) is normal to the element");
            let help = "its projection is the material's direction; choose another system, or an angle";
            return Err(InputError::at(&card.span, message).with_help(help));
        }
        Ok(x.y.atan2(x.x))
    }

    fn section(&self, card: &ShellElement, user: &str) -> Result<ShellSection, InputError> {
        let bulk = self.bulk;
        if let Some(property) = bulk.shell_properties.get(&card.property) {
            return self.plain(property);
        }
        if let Some(laminate) = bulk.laminates.get(&card.property) {
            return self.laminate(laminate);
        }
        let known: Vec<&u32> = bulk.shell_properties.keys().chain(bulk.laminates.keys()).collect();
        Err(undefined(user, "PSHELL or PCOMP", card.property, known.into_iter(), &card.span))
    }

    fn plain(&self, card: &Pshell) -> Result<ShellSection, InputError> {
        let user = format!("PSHELL {}", card.id);
        let t = card.thickness;
        let sound = t > 0.0 && t.is_finite() && card.bending_ratio >= 0.0 && card.shear_ratio >= 0.0;
        if !sound {
            let message = format!(
                "{user} has the thickness {t} and ratios {}, {}",
                card.bending_ratio, card.shear_ratio
            );
            let help = "thickness is positive, 12I/T^3 and TS/T are not negative";
            return Err(InputError::at(&card.span, message).with_help(help));
        }
        let material = |id: Option<u32>| id.map(|id| self.plane(id, &user, &card.span)).transpose();
        let (membrane, bending) = (material(card.membrane)?, material(card.bending)?);
        let shear = card.shear.map(|id| self.transverse(id, &user, &card.span)).transpose()?;
        let q = |material: &Option<PlaneMaterial>| material.map_or_else(Matrix3::zeros, |m| m.stiffness);
        let density = membrane.or(bending).map_or(0.0, |material| material.density);
        let bends = bending.is_some() && card.bending_ratio > 0.0;
        let shear = match shear {
            // A membrane has no transverse stiffness at all.
            _ if !bends => Matrix2::zeros(),
            Some(shear) => shear * (card.shear_ratio * t),
            None => Matrix2::from_element(f64::INFINITY),
        };
        // Nastran's curvatures have the other sign: MID4 is the integral of -z G over T^2 (MSC, Linear Static Analysis User's Guide).
        let coupling = card.coupling.map(|id| self.coupling(id, &user, &card.span)).transpose()?;
        let section = ShellSection {
            membrane: q(&membrane) * t,
            coupling: coupling.unwrap_or_else(Matrix3::zeros) * -t.powi(2),
            bending: q(&bending) * (card.bending_ratio * t.powi(3) / 12.0),
            shear,
            mass_kg_m2: density * t + card.nsm,
            nsm_kg_m2: card.nsm,
            mass_moment_kg_m: 0.0,
            mass_inertia_kg: density * t.powi(3) / 12.0,
        };
        if card.coupling.is_some() && !section.stores_energy() {
            let message =
                format!("{user}: MID4 couples membrane and bending so that some strain has negative energy");
            return Err(InputError::at(&card.span, message)
                .with_help("look at its sign and size beside MID1 and MID2"));
        }
        Ok(if bends { section.with_finite_shear(t) } else { section })
    }

    /// Transverse shear moduli (xz, yz) of what MID3 refers to: G11, G12 and G22 of a MAT2.
    fn transverse(&self, id: u32, user: &str, span: &Span) -> Result<Matrix2<f64>, InputError> {
        let Some(Mat2 { g: [g11, g12, _, g22, ..], span, .. }) = self.bulk.plane_materials.get(&id) else {
            return Ok(self.plane(id, user, span)?.turned_shear(0.0));
        };
        let moduli = Matrix2::new(*g11, *g12, *g12, *g22);
        if moduli.cholesky().is_some() {
            return Ok(moduli);
        }
        let message = format!(
            "MAT2 {id}: G11, G12 and G22 are the transverse shear moduli of {user}, and store no energy"
        );
        Err(InputError::at(span, message)
            .with_help("G11 and G22 must be positive, G12^2 less than their product"))
    }

    /// What MID4 refers to, which alone need not store energy.
    fn coupling(&self, id: u32, user: &str, span: &Span) -> Result<Matrix3<f64>, InputError> {
        let Some(card) = self.bulk.plane_materials.get(&id) else {
            return Ok(self.plane(id, user, span)?.stiffness);
        };
        let [g11, g12, g13, g22, g23, g33] = card.g;
        Ok(Matrix3::new(g11, g12, g13, g12, g22, g23, g13, g23, g33))
    }

    /// A plane material by its number, whatever its kind.
    pub(super) fn plane(&self, id: u32, user: &str, span: &Span) -> Result<PlaneMaterial, InputError> {
        let bulk = self.bulk;
        if let Some(card) = bulk.ply_materials.get(&id) {
            return PlaneMaterial::ply(card);
        }
        if let Some(card) = bulk.plane_materials.get(&id) {
            return PlaneMaterial::anisotropic(card);
        }
        if let Some(card) = bulk.materials.get(&id) {
            return PlaneMaterial::isotropic(card);
        }
        let known: Vec<&u32> = bulk
            .materials
            .keys()
            .chain(bulk.plane_materials.keys())
            .chain(bulk.ply_materials.keys())
            .collect();
        Err(undefined(user, "MAT1, MAT2 or MAT8", id, known.into_iter(), span))
    }
}
