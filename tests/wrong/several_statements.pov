// Ten statements with a mistake each; the others are not complained about.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2 -5> look_at 0 }
#declare Red = rgb <1, 0, 0;
#declare Shiny = texture { pigment { Red } finish { phong 1 } }
spere { 0, 1 texture { Shiny } }
union {
  box { 0, Size pigment { rgb 1 } }
  sphere { 0, 1 texture { Shiny } }
}
#macro Ball(P) sphere { P, Radius } #end
#for (I, 0, 3)
  Ball(I * x)
#end
light_source { 10, rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0 scle 2 } }
sphere { 0, 1 pigment { rgb 1 }
cylinder { -x, x, 0.2 pigment { rgb 1 } rotate 30 x }
#if (1)
  cone { 0, 1, y }
#else
  cone { 0, 1, y, 0 }
#end
torus { 1, 0.2 pigment { rgb <1, 1> } translte y }
