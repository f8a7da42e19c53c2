// dispersion: prism and ball split light into bands.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8> rgb <0.1, 0.3, 0.5> scale 0.5 translate <0.03, 0.1, 0.03> } }
plane { z, 5 pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }
#declare Clear = texture { pigment { rgbf <0.98, 0.98, 1, 0.95> } finish { phong 0.4 } }

prism { linear_spline -0.9, 0.9, 4, <-0.7, -0.5>, <0.7, -0.5>, <0, 0.7>, <-0.7, -0.5> rotate 20 * y translate <-1.3, 0, 0> texture { Clear } interior { ior 1.5 dispersion 1.1 } }
sphere { 1.3 * x, 0.9 texture { Clear } interior { ior 1.4 dispersion 1.06 dispersion_samples 9 } }
