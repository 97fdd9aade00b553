//! Gusts beside independently computed and published results: one test a case of data/published.

#[test]
fn gust_rect_ar6_gust_m0() {
    validation::check("gust__rect_ar6_gust_M0");
}

#[test]
fn gust_bah_gust_frequency_response() {
    validation::check("gust__bah_gust_frequency_response");
}
