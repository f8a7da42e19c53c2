// light_group: with an unsplit union and a difference; inside an unsplit union, where it keeps its light.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0,0.8,-5> look_at 0 angle 42 }
light_source { <-5, 7, -10> rgb 1 }
light_group { light_source { <5,3,-5> rgb <1,.2,.2> } 
 union { sphere { <-1,0,0>, .7 } sphere { <-.5,.4,0>, .5 } split_union off pigment { rgb 1 } }
 difference { box { <.3,-.7,-.7>, <1.7,.7,.7> } sphere { <.6,.2,-.7>, .6 } pigment { rgb <.5,.8,1> } }
 global_lights on
}
union { light_group { light_source { <0,5,-5> rgb <.2,1,.2> } sphere { <0,-1.2,0>, .4 pigment { rgb 1 } } } sphere { <1,-1.2,0>, .4 pigment { rgb 1 } } split_union off }
