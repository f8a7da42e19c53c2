// gradient: along each axis and a slanted one, with colour maps that jump and that blend.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -6> look_at 0 angle 42 }
light_source { <-2, 4, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Tile = box { <-0.9, -0.7, 0>, <0.9, 0.7, 0.1> }
object { Tile translate <-1, 0.8, 0> pigment { gradient x color_map { [0 rgb <0.9, 0.1, 0.1>] [0.5 rgb <0.9, 0.9, 0.1>] [1 rgb <0.1, 0.7, 0.2>] } } }
object { Tile translate <1, 0.8, 0> pigment { gradient y color_map { [0.2 rgb 0] [0.2 rgb <0.3, 0.5, 0.9>] [0.7 rgb 1] [0.7 rgb <0.9, 0.4, 0>] } scale 0.5 } }
object { Tile translate <-1, -0.8, 0> pigment { gradient <1, 1, 0> color_map { [0 rgb 0] [1 rgb 1] } scale 0.4 } }
object { Tile translate <1, -0.8, 0> pigment { gradient <3, -1, 0> color_map { [0 rgb <0.2, 0, 0.3>] [0.3 rgb <1, 0.5, 0.7>] [1 rgb <0.2, 0, 0.3>] } rotate 20 * z } }
