// Nested and overlapping interiors: the list of media a ray is in.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8> rgb <0.1, 0.3, 0.5> scale 0.5 translate <0.03, 0.1, 0.03> } }
plane { z, 5 pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }
#declare Clear = texture { pigment { rgbf <0.98, 0.98, 1, 0.95> } finish { phong 0.4 } }

sphere { <-1.4, 0, 0>, 0.95 texture { Clear } interior { ior 1.33 } }
sphere { <-1.4, 0, 0>, 0.5 texture { Clear } interior { ior 1.6 } }
sphere { <1, 0.1, 0>, 0.7 texture { Clear } interior { ior 1.5 } }
sphere { <1.6, -0.1, 0>, 0.7 texture { Clear } interior { ior 1.2 } }
