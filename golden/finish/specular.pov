// specular highlights: roughness, albedo, metallic, with brilliance beside them.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb <1, 0.95, 0.9> }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb 0.2 translate 0.1 } }
#declare N = 0;
#macro Ball(P, F) sphere { 0, 0.85 pigment { P } finish { F } translate <mod(N, 3) * 2 - 2, 1 - 2 * int(N / 3), 0> #declare N = N + 1; } #end
#declare C = <0.7, 0.4, 0.3>;
Ball(pigment { rgb C }, finish { specular 0.6 }) Ball(pigment { rgb C }, finish { specular 0.6 roughness 0.2 }) Ball(pigment { rgb C }, finish { specular 0.8 roughness 0.005 })
Ball(pigment { rgb C }, finish { specular albedo 0.3 roughness 0.1 }) Ball(pigment { rgb C }, finish { specular 0.8 roughness 0.1 metallic }) Ball(pigment { rgb C }, finish { specular 0.7 phong 0.4 phong_size 70 brilliance 3 })
