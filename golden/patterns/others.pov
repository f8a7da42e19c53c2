// quilted, ripples, waves, facets of functions: patterns used as pigments, pigment_pattern, density_file's kin image_pattern.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

#declare Map = color_map { [0 rgb <0.1, 0.05, 0.3>] [0.4 rgb <0.8, 0.3, 0.2>] [0.7 rgb <1, 0.8, 0.3>] [1 rgb 1] }
Tile(pigment { quilted color_map { Map } scale 0.3 })
Tile(pigment { quilted control0 0.2 control1 1.5 color_map { Map } scale 0.3 rotate 30 })
Tile(pigment { ripples color_map { Map } scale 0.1 })
Tile(pigment { waves color_map { Map } scale 0.1 })
Tile(pigment { ripples frequency 2 phase 0.3 color_map { Map } scale 0.2 })
Tile(pigment { function { x * x + y * 2 } color_map { Map } scale 0.5 })
Tile(pigment { function { sin(x * 20) * cos(y * 15) } color_map { Map } })
Tile(pigment { pigment_pattern { checker rgb <0.2, 0.8, 0.4> rgb <0.9, 0.1, 0.3> scale 0.2 translate 0.013 } color_map { Map } })
Tile(pigment { pigment_pattern { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0>] } } turbulence 0.5 color_map { Map } scale 0.3 })
Tile(pigment { image_pattern { function 8, 8 { x * y } interpolate 2 } color_map { Map } })
Tile(pigment { planar poly_wave 3 color_map { Map } rotate 40 * z translate 0.5 })
Tile(pigment { rgb <0.3, 0.6, 0.9> })
