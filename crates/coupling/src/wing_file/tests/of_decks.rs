//! Wings that are decks: what goes with a fairing, what departs from the drawing, fingerprints of all files.

use crate::planform::Mount;
use crate::wing_file::{DeckSource, Departure, WingFile, fingerprint, hash};
use nastran::{BulkData, Span, parse_deck};
use std::path::PathBuf;

/// A folder of a test's own with files in it.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str, files: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-of-decks-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        let folder = Self(folder);
        for (name, text) in files {
            folder.write(name, text);
        }
        folder
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.0.join(name), text).expect("a temporary file");
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn deck(fairing_panels: &[u32], spline_set: Option<u32>) -> DeckSource {
    DeckSource { file: "wing.bdf".to_owned(), fairing_panels: fairing_panels.to_vec(), spline_set }
}

/// Panels of 2 by 1, 3 by 2 and 1 by 2 boxes, the middle one with listed divisions, and an incidence for each box.
const CARDS: &str = "GRID,1,,0.,0.,0.\nGRID,2,,0.,1.,0.\nGRID,3,,0.,2.,0.\nGRID,4,,1.,2.,0.\nRBE2,7,3,123456,4\n\
    SPC1,1,123456,1\nMONPNT3,ROOT,BALANCE\n,123456,5\nSET1,5,2,3\nPAERO1,1\nAEFACT,31,0.,.2,.6,1.\nAEFACT,32,0.,.5,1.\n\
    CAERO1,100,1,,1,2,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\n\
    CAERO1,200,1,,,,32,31,1\n,0.,1.,0.,1.,0.,2.,0.,1.\n\
    CAERO1,300,1,,2,1,,,1\n,0.,2.,0.,1.,0.,3.,0.,1.\n\
    DMI,W2GJ,0,2,1,0,,10,1\nDMI,W2GJ,1,1,.01,.02,.03,.04,.05\n,.06,.07,.08,.09,.1\n";

#[test]
fn a_fairing_goes_with_its_rows_of_incidence_and_an_aircraft_has_no_clamps() {
    let folder = Folder::new("fairing", &[("wing.bdf", CARDS)]);
    let rows = |fairing: &[u32], mount: Mount| {
        let bulk = deck(fairing, None).bulk(&folder.0, mount).expect("a deck");
        let matrix = &bulk.matrices["W2GJ"];
        assert_eq!(matrix.rows, matrix.columns[0].len());
        let hundredths: Vec<f64> = matrix.columns[0].iter().map(|v| (100.0 * v).round()).collect();
        (hundredths, bulk)
    };
    let whole: Vec<f64> = (1..=10).map(f64::from).collect();
    let (tunnel, bulk) = rows(&[200], Mount::Tunnel);
    assert_eq!(tunnel, whole);
    assert_eq!(bulk.panels.keys().copied().collect::<Vec<_>>(), [100, 200, 300]);
    assert!(bulk.constraints.len() == 1 && bulk.monitors.len() == 1);
    let (flying, bulk) = rows(&[200], Mount::Aircraft);
    assert_eq!(flying, [1.0, 2.0, 9.0, 10.0]);
    assert_eq!(bulk.panels.keys().copied().collect::<Vec<_>>(), [100, 300]);
    assert!(bulk.constraints.is_empty() && bulk.monitors.is_empty());
    assert_eq!(rows(&[100], Mount::Aircraft).0, whole[2..]);
    assert_eq!(rows(&[100, 300], Mount::Aircraft).0, whole[2..8]);
    assert_eq!(rows(&[], Mount::Aircraft).0, whole);
    let without = |l: &&str| !l.contains("W2GJ") && !l.starts_with(",.06");
    let bare = CARDS.lines().filter(without).collect::<Vec<_>>().join("\n");
    folder.write("wing.bdf", &bare);
    assert!(deck(&[200], None).bulk(&folder.0, Mount::Aircraft).expect("a deck").matrices.is_empty());
}

#[test]
fn boxes_follow_the_set_or_all_grids_that_follow_no_other() {
    let bulk = parse_deck("wing.bdf", CARDS).expect("a deck");
    assert_eq!(deck(&[], None).spline_grid_ids(&bulk), [1, 2, 3]);
    assert_eq!(deck(&[], Some(5)).spline_grid_ids(&bulk), [2, 3]);
    assert!(deck(&[], Some(6)).spline_grid_ids(&bulk).is_empty());
    let said = |source: &DeckSource| {
        let at = Span::generated("a test");
        source.check(&bulk).err().map(|fault| fault.at(&at).to_string()).unwrap_or_default()
    };
    assert_eq!(said(&deck(&[100, 300], Some(5))), "");
    assert_eq!(said(&deck(&[], None)), "");
    assert!(said(&deck(&[100, 101], Some(5))).contains("no CAERO1 101"));
    assert!(said(&deck(&[100], Some(6))).contains("no SET1 6"));
}

/// A factor f on the flexibility in bending and t in torsion divides direct moduli by f and shear moduli by t.
#[test]
fn a_softer_wing_has_moduli_divided_by_its_factors() {
    let cards = "MAT1,1,8.+10,3.+10,,2700.\nMAT2,2,1.+10,2.+10,3.+10,4.+10,5.+10,6.+10\n\
        MAT8,3,4.+10,9.+9,.3,5.+9,4.+9,3.+9\nMAT9,4,1.+10,2.+10,3.+10,4.+10,5.+10,6.+10,7.+10\n\
        ,8.+10,9.+10,1.+11,2.+11,3.+11,4.+11,5.+11,6.+11\n,7.+11,8.+11,9.+11,1.+12,2.+12,3.+12\n\
        PAERO1,1\nCAERO1,100,1,,1,2,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\n\
        AELIST,11,100\nAELIST,12,101\nCORD2R,9,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n\
        AESURF,1,AIL,9,11,,,.8\nAESURF,2,FLAP,9,12\n";
    let drawn = parse_deck("drawn.bdf", cards).expect("a deck");
    let with = |log_flexibility: [f64; 2], controls: &[(&str, f64)]| {
        let mut bulk = drawn.clone();
        let controls = controls.iter().map(|(name, factor)| ((*name).to_owned(), *factor)).collect();
        Departure { log_flexibility, controls }.put_into(&mut bulk);
        bulk
    };
    let same =
        |found: f64, expected: f64| assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
    for [bending, torsion] in [[4.0, 9.0_f64], [1.0, 2.0], [2.0, 1.0]] {
        let (soft, mean) = (with([f64::ln(bending), torsion.ln()], &[]), (bending * torsion).sqrt());
        same(soft.materials[&1].e, 8e10 / bending);
        same(soft.materials[&1].g, 3e10 / torsion);
        assert_eq!(soft.materials[&1].rho, 2700.0);
        let plane =
            [1e10 / bending, 2e10 / bending, 3e10 / mean, 4e10 / bending, 5e10 / mean, 6e10 / torsion];
        soft.plane_materials[&2].g.iter().zip(plane).for_each(|(found, expected)| same(*found, expected));
        let ply = &soft.ply_materials[&3];
        same(ply.e1, 4e10 / bending);
        same(ply.e2, 9e9 / bending);
        same(ply.nu12, 0.3);
        for (found, expected) in [(ply.g12, 5e9), (ply.g1z, 4e9), (ply.g2z, 3e9)] {
            same(found, expected / torsion);
        }
        for (found, before) in soft.solid_materials[&4].g.iter().zip(&drawn.solid_materials[&4].g) {
            same(*found, before / bending);
        }
    }
    assert_eq!(with([0.0; 2], &[]), drawn);
    let built = with([0.0; 2], &[("AIL", 0.5), ("none", 7.0)]);
    same(built.surfaces[&1].effectiveness, 0.4);
    same(built.surfaces[&2].effectiveness, drawn.surfaces[&2].effectiveness);
    assert_eq!(BulkData { surfaces: drawn.surfaces.clone(), ..built }, drawn);
}

#[test]
fn fingerprints_are_those_of_the_published_hash_and_of_all_files_that_are_included() {
    // FNV-1a with 64 bits over the bytes and the border.
    let fnv = |bytes: &[u8]| {
        let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        format!("{:016x}", bytes.iter().fold(0xcbf2_9ce4_8422_2325, step))
    };
    assert_eq!(fingerprint("foobar"), fnv(b"foobar\xff"));
    assert_eq!(fingerprint("a\r\nb"), fnv(b"a\nb\xff"));
    assert_eq!(fingerprint(""), fnv(b"\xff"));
    let (outer, inner) = ("$ a\nINCLUDE 'inner.bdf'\n$ b\n", "include \"last.bdf\"\n");
    let files = [("wing.bdf", outer), ("inner.bdf", inner), ("last.bdf", "$ end\n")];
    let folder = Folder::new("hash", &files);
    let of = |names: &[&str]| {
        let files: Vec<PathBuf> = names.iter().map(|name| folder.0.join(name)).collect();
        hash::of_files("wing", &files)
    };
    let all = [&b"wing\xff"[..], outer.as_bytes(), b"\xff", inner.as_bytes(), b"\xff$ end\n\xff"].concat();
    assert_eq!(of(&["wing.bdf"]).expect("files"), fnv(&all));
    assert_eq!(of(&[]).expect("nothing"), fnv(b"wing\xff"));
    assert_eq!(of(&["last.bdf", "last.bdf"]).expect("files"), fnv(b"wing\xff$ end\n\xff$ end\n\xff"));
    assert!(of(&["missing.bdf"]).is_err());
    // A deck that includes itself ends after twenty inner ones.
    folder.write("wing.bdf", "INCLUDE wing.bdf\n");
    let circle = [&b"wing\xff"[..], &b"INCLUDE wing.bdf\n\xff".repeat(21)[..]].concat();
    assert_eq!(of(&["wing.bdf"]).expect("it ends"), fnv(&circle));
}

#[test]
fn a_wings_file_finds_its_deck_beside_it_and_knows_what_the_deck_lacks() {
    let wing = "Wing(name: \"deck\", source: Deck((file: \"wing.bdf\", fairing_panels: [200], spline_set: 5)), \
        balance: (x_m: 0.0, y_m: 0.0, z_m: 0.0), correction: (chord_strips: 2, span_order: 1))\n";
    let folder = Folder::new("read", &[("wing.bdf", CARDS), ("wing.ron", wing)]);
    let read = |text: &str| {
        folder.write("wing.ron", text);
        WingFile::read(&folder.0.join("wing.ron"))
    };
    // Panel 100 has 2 boxes of a chord, 300 has 1: one strip is all that both have.
    let refused = read(wing).expect_err("a strip of half a box").to_string();
    assert!(refused.contains("does not divide the 1 boxes") && refused.contains("wing.ron:1:"), "{refused}");
    let good = wing.replace("chord_strips: 2", "chord_strips: 1");
    let file = read(&good).expect("a wing");
    assert_eq!(file.fairing_panel_ids(), [200]);
    assert!(file.planform().is_none() && file.deflection_limit_deg("AIL").is_none());
    let bulk = file.bulk(Mount::Aircraft).expect("a deck");
    assert_eq!(file.spline_grid_ids(&bulk), [2, 3]);
    assert_eq!(file.hash.len(), 16);
    for (from, to, word) in [
        ("[200]", "[201]", "no CAERO1 201"),
        ("spline_set: 5", "spline_set: 6", "no SET1 6"),
        ("wing.bdf", "none.bdf", "none.bdf"),
    ] {
        let refused = read(&good.replace(from, to)).expect_err(word).to_string();
        assert!(refused.contains(word), "{refused}");
    }
    folder.write("wing.bdf", &CARDS.replace("GRID,2,,0.,1.", "GRID,2,,0.,1.1"));
    assert_ne!(read(&good).expect("a wing").hash, file.hash);
}
