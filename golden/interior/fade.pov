// fade_distance and fade_power in an interior, both models, with fade_color; shadows fade as well.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8> rgb <0.1, 0.3, 0.5> scale 0.5 translate <0.03, 0.1, 0.03> } }
plane { z, 5 pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }
#declare Clear = texture { pigment { rgbf <0.98, 0.98, 1, 0.95> } finish { phong 0.4 } }

sphere { <-2, 0, 0>, 0.8 texture { Clear } interior { ior 1.2 fade_distance 0.6 fade_power 2 fade_color rgb <0.1, 0.6, 0.3> } }
sphere { 0, 0.8 texture { Clear } interior { ior 1.2 fade_distance 0.8 fade_power 1001 fade_color rgb <0.8, 0.4, 0.1> } }
box { <-0.6, -0.6, -0.6>, 0.6 rotate 25 * y translate 2 * x texture { Clear } interior { ior 1.1 fade_distance 1 fade_power 1 } }
