// Below version 3.7 ambient light stays, and adds to what is gathered.
#version 3.6;
global_settings { assumed_gamma 1 radiosity { count 50 nearest_count 3 } }
camera { location <0, 1.5, -4.5> look_at <0, 1.2, 0> right 4/3*x up y angle 65 }

#declare Wall = finish { ambient 0.15 diffuse 0.6 }
light_source { <0.5, 2.6, -1>, rgb 0.7 fade_distance 2 fade_power 2 }
box { <-2, 0, -5>, <2, 3, 2> hollow pigment { rgb 0.9 } finish { Wall } }
box { <-2, 0, -5>, <-1.98, 3, 2> pigment { rgb <0.9, 0.3, 0.2> } finish { Wall } }
box { <1.98, 0, -5>, <2, 3, 2> pigment { rgb <0.2, 0.4, 0.9> } finish { Wall } }

box { <-1.3, 0, -0.2>, <-0.4, 1.5, 0.6> pigment { rgb 0.8 } finish { Wall } }
