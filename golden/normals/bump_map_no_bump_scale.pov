// A bump_map without bump scale: a normal along y whose length is not 1 is taken to point down, so the top is dark.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <1.5, 2.5, -4> look_at 0 angle 42 }
light_source { <-3, 9, -7> rgb 1 }
#declare Bumps = normal { bump_map { function 6, 6 { 0.5 + 0.5 * sin(9 * x) * cos(8 * y) } bump_size 4 } no_bump_scale scale 1.3 translate 0.1 }
box { -1, 1 pigment { rgb <0.8, 0.6, 0.4> } normal { Bumps } rotate 20 * y }
