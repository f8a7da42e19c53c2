// A pattern written over a plain colour takes over the colour's modifiers and transformations, wherever they came from.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.1, -8> look_at <0, -0.05, 0> angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0.3 } }
#declare Moved = texture { pigment { rgb 1 } rotate 40 * z scale 0.37 }
#declare Ball = sphere { 0, 0.62 texture { pigment { rgb 1 } } scale <0.7, 1, 1> }
#declare Hues = color_map { [0 rgb <0.8, 0.3, 0.2>] [1 rgb <0.9, 0.9, 0.4>] }
object { Ball scale <1.8, 0.9, 0.9> pigment { gradient x color_map { Hues } } translate <-2.1, 1.4, 0> }
sphere { 0, 0.6 texture { Moved pigment { gradient x color_map { Hues } } } translate <-0.7, 1.4, 0> }
sphere { 0, 0.6 pigment { rgb 1 turbulence 0.4 scale 0.3 } pigment { gradient y color_map { Hues } } translate <0.7, 1.4, 0> }
sphere { 0, 0.6 pigment { rgb 1 frequency 3 phase 0.4 sine_wave } pigment { onion color_map { Hues } } translate <2.1, 1.4, 0> }
sphere { 0, 0.6 pigment { gradient y scale 0.21 } pigment { rgb 1 } pigment { gradient x color_map { Hues } } translate <-2.1, 0, 0> }
sphere { 0, 0.6 pigment { rgb 1 warp { repeat 0.3 * x flip x } } pigment { wood color_map { Hues } } translate <-0.7, 0, 0> }
union { sphere { 0, 0.6 } sphere { 0.3 * y, 0.4 } finish { phong 1 } scale <0.8, 1.1, 1> pigment { checker rgb <0.9, 0.9, 0.4>, rgb <0.2, 0.3, 0.7> scale 0.31 } translate <0.7, 0, 0> }
#default { pigment { rgb <0.3, 0.6, 0.8> rotate 30 * z scale <0.2, 0.4, 0.3> } }
sphere { 0, 0.6 pigment { gradient x color_map { Hues } } translate <2.1, 0, 0> }
sphere { 0, 0.6 translate <-2.1, -1.4, 0> }
#declare P = pigment { rgb <0.5, 0.2, 0.6> translate 0.1 * x }
sphere { 0, 0.6 pigment { P gradient y color_map { Hues } } translate <-0.7, -1.4, 0> }
sphere { 0, 0.6 pigment { gradient x pigment_map { [0.4 rgb 1] [0.6 bozo color_map { Hues }] } } translate <0.7, -1.4, 0> }
sphere { 0, 0.6 texture { pigment { P } finish { phong 1 } } rotate 50 * x pigment { gradient y color_map { Hues } } translate <2.1, -1.4, 0> }
