// image_map: planar, repeated, once only, and with interpolation; the picture is image_map.png beside this file.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -6> look_at 0 angle 42 }
light_source { <-2, 4, -9> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Tile = box { <-0.9, -0.7, 0>, <0.9, 0.7, 0.1> }
object { Tile pigment { image_map { png "image_map.png" } scale 0.9 } translate <-1, 0.8, 0> }
object { Tile pigment { image_map { png "image_map.png" once } scale 1.2 translate <-0.6, -0.6, 0> } translate <1, 0.8, 0> }
object { Tile pigment { image_map { png "image_map.png" interpolate 2 } scale 1.8 translate <-0.9, -0.7, 0> } translate <-1, -0.8, 0> }
object { Tile pigment { image_map { png "image_map.png" filter all 0.4 } rotate 30 * z scale 0.7 } translate <1, -0.8, 0> }
