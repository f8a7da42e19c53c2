// reflection by angle: fresnel, falloff, exponent, metallic, conserve_energy.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb <1, 0.95, 0.9> }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb 0.2 translate 0.1 } }
#declare N = 0;
#macro Ball(P, F) sphere { 0, 0.85 pigment { P } finish { F } translate <mod(N, 3) * 2 - 2, 1 - 2 * int(N / 3), 0> #declare N = N + 1; } #end
#macro Glass(F) sphere { 0, 0.85 pigment { rgbt <0.8, 0.9, 0.7, 0.6> } finish { F } interior { ior 1.6 } translate <mod(N, 3) * 2 - 2, 1 - 2 * int(N / 3), 0> #declare N = N + 1; } #end
#declare C = <0.7, 0.4, 0.3>;
Glass(finish { reflection { 0.05, 0.9 fresnel } }) Glass(finish { reflection { 0.05, 0.9 fresnel } conserve_energy }) Ball(pigment { rgb C }, finish { reflection { 0.1, 0.8 falloff 3 } })
Ball(pigment { rgb C }, finish { reflection { 0.6 metallic } }) Ball(pigment { rgb C }, finish { reflection { 0.5 exponent 1.8 } }) Ball(pigment { rgb C }, finish { reflection { rgb <0.1, 0.3, 0.6>, rgb <0.9, 0.6, 0.2> metallic 0.5 } })
