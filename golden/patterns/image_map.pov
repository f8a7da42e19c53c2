// image_map: map types, once, interpolation, and function images.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end
#macro Ball(P) sphere { 0, 0.47 pigment { P } rotate <-20, 30, 0> translate <mod(N, 4) + 0.5, int(N / 4) + 0.5, 0> } #declare N = N + 1; #end
#declare Red = function { x }
Tile(pigment { image_map { function 16, 12 { pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.1, 0.3, 0.6> scale 0.3 translate 0.01 } } } })
Tile(pigment { image_map { function 5, 5 { x * y } interpolate 2 } })
Tile(pigment { image_map { function 5, 5 { x } interpolate 4 } rotate 30 * z scale 0.5 })
Tile(pigment { image_map { function 5, 5 { abs(x - y) } once } scale 0.6 translate 0.2 })
Ball(pigment { image_map { function 16, 12 { pigment { checker rgb <0.9, 0.8, 0.3> rgb <0.1, 0.3, 0.6> scale 0.3 translate 0.01 } } map_type 1 } })
Ball(pigment { image_map { function 16, 12 { x } map_type 1 interpolate 2 } })
Ball(pigment { image_map { function 16, 12 { 0.5 + 0.5 * sin(x * 20) * y } map_type 2 } translate -0.5 * y })
Ball(pigment { image_map { function 16, 12 { mod(x * 3, 1) } map_type 5 } scale 0.3 })
Tile(pigment { image_map { function 6, 6 { pigment { gradient x color_map { [0 rgbt <1, 0, 0, 0>] [1 rgbt <0, 1, 0, 0.8>] } } } } })
Tile(pigment { image_map { function 6, 6 { y } transmit all 0.5 } })
Ball(pigment { image_map { function 9, 9 { x } interpolate 3 } scale 0.7 })
Tile(pigment { image_map { function 4, 4 { x * 0.5 + y * 0.5 } interpolate 3 } })
