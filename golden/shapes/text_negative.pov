// text: negative thickness has two faces and no sides; offset; kerned letters; a solid cut by letters.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <-1.5, 1.5, -5> look_at <0.2, 0, 0> angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

text { ttf "timrom.ttf" "Two" -0.5, 0.1 * x translate <-1.4, 0.4, 0> pigment { rgb <0.8, 0.7, 0.3> } }
difference {
  box { <-1.5, -0.9, 0>, <1.6, 0.1, 0.4> pigment { rgb <0.4, 0.5, 0.8> } }
  text { ttf "crystal.ttf" "AVo" 0.4, 0 scale <1.2, 1, 1> translate <-1.3, -0.7, -0.2> pigment { rgb <0.9, 0.5, 0.3> } }
}
