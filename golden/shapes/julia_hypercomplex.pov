// julia_fractal: hypercomplex, squared and reciprocal.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

julia_fractal { <-0.162, 0.163, 0.56, -0.599> hypercomplex sqr max_iteration 6 precision 50 translate -1.5 * x pigment { rgb <0.8, 0.3, 0.2> } }
julia_fractal { <-0.3, 0.4, 0.1, 0.2> hypercomplex sqr max_iteration 5 precision 60 rotate 40 * y translate 1.5 * x pigment { rgb <0.3, 0.7, 0.3> } }
