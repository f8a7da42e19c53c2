// ior: solid glass, hollow glass with air inside, a lens, and glass in water.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8> rgb <0.1, 0.3, 0.5> scale 0.5 translate <0.03, 0.1, 0.03> } }
plane { z, 5 pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }
#declare Clear = texture { pigment { rgbf <0.98, 0.98, 1, 0.95> } finish { phong 0.4 } }

sphere { <-2.1, 0, 0>, 0.8 texture { Clear } interior { ior 1.5 } }
difference { sphere { 0, 0.8 } sphere { 0, 0.7 } translate -0.2 * x texture { Clear } interior { ior 1.5 } }
intersection { sphere { -0.6 * z, 1 } sphere { 0.6 * z, 1 } translate <1.5, 0.5, 0> texture { Clear } interior { ior 1.4 } }
box { <0.9, -0.95, -0.6>, <2.3, -0.45, 0.6> rotate 10 * y texture { Clear } interior { ior 1.33 } }
