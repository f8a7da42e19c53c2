// Block patterns whose items are pigments, textures or nested blocks.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { orthographic location <2, 1.5, -8> right 4 * x up 3 * y direction z }
background { rgb <0.1, 0.12, 0.2> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare N = 0;
#macro Tile(P) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> pigment { P } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end
#macro Tex(T) box { <0.03, 0.03, 0>, <0.97, 0.97, 0.1> texture { T } translate <mod(N, 4), int(N / 4), 0> } #declare N = N + 1; #end

Tile(pigment { checker pigment { gradient x scale 0.1 } pigment { rgb <0.8, 0.3, 0.1> } scale 0.3 translate 0.013 })
Tile(pigment { hexagon pigment { checker scale 0.3 } pigment { rgb 1 } pigment { onion scale 0.2 } scale 0.3 rotate 70 * x })
Tile(pigment { brick pigment { rgb 0.7 } pigment { bozo scale 0.5 } brick_size <0.4, 0.2, 0.3> mortar 0.04 })
Tile(pigment { object { torus { 0.3, 0.12 rotate 90 * x translate <0.5, 0.5, 0> } pigment { wood scale 0.1 } pigment { gradient y scale 0.2 } } })
Tex(texture { checker texture { pigment { rgb <0.9, 0.8, 0.2> } finish { emission 1 diffuse 0 } } texture { pigment { rgb <0.2, 0.3, 0.7> } finish { emission 0.4 diffuse 0 } } scale 0.26 translate 0.013 })
Tex(texture { cubic texture { pigment { rgb x } finish { emission 1 } } texture { pigment { rgb y } finish { emission 1 } } texture { pigment { rgb z } finish { emission 1 } } texture { pigment { rgb 1 } finish { emission 1 } } texture { pigment { rgb 0.5 } finish { emission 1 } } texture { pigment { rgb x + y } finish { emission 1 } } rotate 30 translate 0.5 })
Tile(pigment { square pigment { rgb 1 } pigment { agate scale 0.5 } pigment { leopard scale 0.06 } pigment { rgb 0.2 } scale 0.27 rotate 80 * x translate 0.013 })
Tile(pigment { triangular pigment { rgb 1 } pigment { rgb 0.8 } pigment { rgb 0.6 } pigment { rgb 0.4 } pigment { gradient x scale 0.2 } pigment { gradient z scale 0.2 } scale 0.4 rotate 80 * x translate 0.013 })
