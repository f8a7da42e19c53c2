// bounded_by around single shapes that reach out of it: a quartic, text, a torus and a quadric; in a solid, too.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

quartic { <1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1>
  bounded_by { sphere { 0, 0.9 } } translate <-1.7, 0.9, 0> pigment { rgb <0.8, 0.5, 0.3> } }
torus { 0.7, 0.3 rotate -70 * x bounded_by { box { <-0.8, -0.6, -2>, <0.7, 2, 2> } } translate <0.3, 0.8, 0> pigment { rgb <0.3, 0.7, 0.4> } }
quadric { <1, 1, -0.5>, 0, 0, -0.3 bounded_by { sphere { 0, 1.1 } } rotate 60 * y translate <2.1, 0.5, 0> pigment { rgb <0.4, 0.5, 0.9> } }
text { ttf "timrom.ttf" "Bound" 0.3, 0 bounded_by { box { <0.2, -1, -1>, <2.2, 0.5, 1> } } translate <-2.2, -1.2, 0> pigment { rgb <0.9, 0.8, 0.4> } }
intersection {
  sphere { 0, 0.9 bounded_by { box { <-0.5, -2, -2>, <2, 2, 2> } } }
  box { -0.7, 0.7 }
  translate <1.4, -1, 0> pigment { rgb <0.8, 0.4, 0.7> }
}
