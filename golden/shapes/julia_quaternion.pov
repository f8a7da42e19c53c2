// julia_fractal: quaternions, squared and cubed, with a slice.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 20 translate -1.5 * x pigment { rgb <0.8, 0.5, 0.2> } }
julia_fractal { <-0.2, 0.6, 0.2, 0.3> quaternion cube max_iteration 6 precision 30 slice <0.2, 0.1, 0, 1>, 0.1 rotate 30 * y translate 1.5 * x pigment { rgb <0.3, 0.6, 0.8> } }
