// rainbows with arc, falloff, filter and transmit; two that overlap.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1, -6> look_at <0, 2, 0> angle 70 }
light_source { <0, 4, -20> rgb 1 }
background { rgb <0.35, 0.45, 0.6> }
plane { y, 0 pigment { checker rgb <0.3, 0.5, 0.2> rgb <0.2, 0.4, 0.2> translate 0.1 } }
sphere { <-1, 1, 1>, 0.9 pigment { rgb 0.8 } }
#declare Bow = color_map { [0 rgbft <0.9, 0.3, 0.3, 0.3, 0.8>] [0.5 rgbft <0.3, 0.9, 0.3, 0.2, 0.5>] [1 rgbft <0.3, 0.3, 0.9, 0.3, 0.9>] }
rainbow { angle 24 width 8 distance 5 direction <0, 0.15, 1> color_map { Bow } arc_angle 150 falloff_angle 70 }
rainbow { angle 30 width 10 distance 9 direction <0.1, 0.1, 1> color_map { Bow } }
