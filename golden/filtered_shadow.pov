// filtered shadow: light through coloured glass by filter and by transmit, and through two panes.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4, -6> look_at <0, 0, 0.5> angle 42 }
light_source { <0, 8, -1> rgb 1.2 }
plane { y, -1 pigment { rgb 0.9 } }

box { <-2.2, 0.2, -0.6>, <-0.8, 0.25, 1> pigment { rgbf <0.9, 0.2, 0.1, 0.8> } }
box { <-0.3, 0.2, -0.6>, <1.1, 0.25, 1> pigment { rgbt <0.1, 0.3, 0.9, 0.6> } }
box { <0.5, 0.6, -0.2>, <2, 0.65, 1.4> pigment { rgbft <0.2, 0.9, 0.2, 0.5, 0.2> } }
