// Block patterns with colours of their own and with the built-in ones.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(pigment { checker rgb <0.9, 0.8, 0.6> rgb <0.4, 0.1, 0.1> scale 0.17 translate 0.013 })
Tile(pigment { checker scale 0.23 rotate <20, 30, 10> })
Tile(pigment { brick rgb 0.8 rgb <0.6, 0.2, 0.1> scale 0.05 translate 0.013 })
Tile(pigment { brick brick_size <0.4, 0.2, 0.3> mortar 0.05 rotate <10, 20, 0> })
Tile(pigment { hexagon rgb <0.9, 0.8, 0.2> rgb <0.2, 0.4, 0.8> rgb <0.7, 0.2, 0.3> scale 0.13 rotate 80 * x })
Tile(pigment { hexagon scale 0.2 rotate <50, 20, 30> })
Tile(pigment { square rgb 1 rgb <0.2, 0.4, 0.8> rgb 0.3 rgb <0.9, 0.6, 0.1> scale 0.19 rotate 70 * x translate 0.013 })
Tile(pigment { square scale 0.3 rotate <60, 0, 20> translate 0.013 })
Tile(pigment { triangular rgb 1 rgb <0.2, 0.4, 0.8> rgb 0.3 rgb <0.9, 0.6, 0.1> rgb <0.1, 0.6, 0.3> rgb <0.6, 0.1, 0.5> scale 0.2 rotate 70 * x translate 0.013 })
Tile(pigment { triangular scale 0.3 rotate <110, 0, 20> })
Tile(pigment { cubic translate <0.45, 0.52, 0.3> })
Tile(pigment { object { union { sphere { 0.4, 0.35 } box { <0.6, 0.1, -1>, <0.9, 0.9, 1> } } rgb <0.9, 0.8, 0.6> rgb <0.2, 0.3, 0.7> } })
