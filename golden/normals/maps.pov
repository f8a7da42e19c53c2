// slope_map, normal_map, average, and bump vectors under scaling.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
light_source { <-7, 9, -5> rgb 1.3 }
background { rgb <0.1, 0.12, 0.2> }
#default { pigment { rgb <0.9, 0.85, 0.8> } finish { ambient 0 diffuse 0.8 } }
#declare N = 0;
#macro Tile(B) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> normal { B } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(normal { gradient x, 2 slope_map { [0 <0, 1>] [0.4 <0.7, -0.5>] [0.8 <0.2, 0>] [1 <0, 0>] } scale 0.3 })
Tile(normal { onion 2 slope_map { [0 <0, 0>] [0.5 <1, 0>] [1 <0, 0>] } scale 0.3 translate 0.5 })
Tile(normal { gradient x normal_map { [0.2 bumps 0.5 scale 0.1] [0.8 quilted 0.7 scale 0.1] } })
Tile(normal { average normal_map { [1 bumps 0.8 scale 0.1] [2 ripples 0.6 scale 0.1] } })
Tile(normal { bumps 0.6 scale 0.1 scale <3, 1, 1> })
Tile(normal { bumps 0.6 no_bump_scale scale 0.1 scale <3, 1, 1> })
Tile(normal { gradient x normal_map { [0 gradient y, 2 sine_wave scale 0.2] [1 gradient x, 2 sine_wave scale 0.2] } rotate 30 * z })
Tile(normal { checker normal { gradient x normal_map { [0 bumps 0.5] [1 onion 0.5] } } normal { wrinkles 0.5 } scale 0.4 translate 0.013 })
