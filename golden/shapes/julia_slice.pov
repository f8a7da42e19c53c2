// julia_fractal: hypercomplex cube and square, with a slice.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -9> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

julia_fractal { <-0.2, 0.4, -0.4, 0.3> hypercomplex sqr max_iteration 5 precision 60 slice <0.2, 0.1, 0, 1>, 0.1 translate <-1.8, 0, 0> pigment { rgb <0.8, 0.5, 0.2> } }
julia_fractal { <0.4, -0.2, 0.1, 0.3> hypercomplex cube max_iteration 6 precision 60 translate <1.8, 0, 0> pigment { rgb <0.3, 0.6, 0.8> } }
