// julia_fractal: functions of hypercomplex numbers.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

julia_fractal { <-0.2, 0.4, -0.4, 0.3> hypercomplex cos max_iteration 3 precision 60 scale 0.35 translate <-1.5, 1, 0> pigment { rgb <0.8, 0.3, 0.2> } }
julia_fractal { <0.1, 0.3, -0.2, 0.1> hypercomplex pwr(3, 0) max_iteration 4 precision 60 scale 0.8 translate <1.5, 1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
julia_fractal { <0.2, 0.2, -0.3, 0.1> hypercomplex sin max_iteration 3 precision 60 scale 0.35 translate <1.5, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
