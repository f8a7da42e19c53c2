// Fog without an altitude: a floor that lies exactly at its offset stands above it.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -6> look_at 0 angle 50 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.4, 0.6, 0.9> }
fog { fog_type 2 distance 4 rgb <0.9, 0.5, 0.4> fog_offset -0.5 }
plane { y, -0.5 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.3> translate 0.5 * y } }
sphere { <-1, 0.1, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } }
