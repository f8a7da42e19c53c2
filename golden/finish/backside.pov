// diffuse light on the far side, emission, and ambient with ambient_light.
#version 3.7;
global_settings { assumed_gamma 1.0 }
global_settings { ambient_light rgb <1, 0.8, 0.6> }
camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb <1, 0.95, 0.9> }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb 0.2 translate 0.1 } }
#declare N = 0;
#macro Ball(P, F) sphere { 0, 0.85 pigment { P } finish { F } translate <mod(N, 3) * 2 - 2, 1 - 2 * int(N / 3), 0> #declare N = N + 1; } #end
#declare Sheet = disc { 0, z, 0.9 pigment { rgb <0.9, 0.8, 0.5> } }
light_source { <3, 2, 6> rgb 0.7 }
object { Sheet finish { diffuse 0.6, 0.5 } rotate 20 * y translate <-2, 1, 0> }
object { Sheet finish { diffuse 0.2, 0.8 brilliance 2 } rotate -30 * y translate <0, 1, 0> }
object { Sheet double_illuminate rotate 30 * x translate <2, 1, 0> }
#declare N = 3;
Ball(pigment { rgb <0.5, 0.7, 0.3> }, finish { emission rgb <0.3, 0.1, 0.2> }) Ball(pigment { rgb <0.5, 0.7, 0.3> }, finish { ambient rgb <0.1, 0.3, 0.5> }) Ball(pigment { rgbf <0.5, 0.7, 0.3, 0.6> }, finish { emission 0.3 ambient 0.2 })
