//! The tests of `tests` that need no process of their own, as one program: linked once, and both cores busy to the end.

mod loads_kernel;
mod loads_kernel_chirp;
mod loads_kernel_static;
mod panelaero;
mod panelaero_dlm;
mod panelaero_vlm;
mod paper_m_models;
mod paper_s_aircraft;
mod paper_s_calibration;
mod paper_s_formulation;
mod published_cases;
mod published_dlm;
mod published_flutter;
mod published_gusts;
mod published_laminates;
mod published_pazy;
mod published_shells;
mod published_solids;
mod published_trim;
mod published_vibrations;
mod published_vlm;
mod shipped_aircraft;
mod shipped_campaign;
mod strips_and_measured_vlm;
mod theodorsen_dlm;
mod typical_section_divergence;
