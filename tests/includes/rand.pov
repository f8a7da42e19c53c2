// Every distribution, drawn twenty times; what the stream gives afterwards shows how often each draws.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "rand.inc"
#macro Show(V) #debug concat("@", vstr(3, 0 + V, ", ", 0, 8), "\n") #end
#declare R = seed(7);
#declare Ball = union { sphere { <1, 2, 3>, 1 } box { <2, 2, 2>, <3, 5, 3> } }
Show(<rand(RdmA), rand(RdmB), rand(RdmC)>)
Show(rand(RdmD))
#for (I, 1, 20)
  Show(<SRand(R), RRand(2, 5, R), rand(R)>)
  Show(VRand(R))
  Show(VRand_In_Box(<1, 2, 3>, <2, 4, 7>, R))
  Show(VRand_In_Sphere(R))
  Show(VRand_On_Sphere(R))
  #declare P = VRand_In_Obj(Ball, R);
  Show(P)
  #declare A = Rand_Cauchy(1, 2, R); Show(A)
  #declare A = Rand_Student(4, R); Show(A)
  #declare A = Rand_Normal(1, 2, R); Show(A)
  #declare A = Rand_Gauss(1, 2, R); Show(A)
  #declare A = Rand_Gamma(2.5, 3, R); Show(A)
  #declare A = Rand_Gamma(1, 3, R); Show(A)
  #declare A = Rand_Gamma(0.5, 1, R); Show(A)
  #declare A = Rand_Beta(2, 3, R); Show(A)
  #declare A = Rand_Chi_Square(3, R); Show(A)
  #declare A = Rand_F_Dist(3, 4, R); Show(A)
  #declare A = Rand_Erlang(2, 3, R); Show(A)
  #declare A = Rand_Exp(2, R); Show(A)
  #declare A = Rand_Lognormal(0.2, 0.5, R); Show(A)
  #declare A = Rand_Pareto(2, R); Show(A)
  #declare A = Rand_Weibull(2, 3, R); Show(A)
  #declare A = Rand_Bernoulli(0.4, R); Show(A)
  #declare A = Prob(0.6, R); Show(A)
  #declare A = Rand_Binomial(10, 0.3, R); Show(A)
  #declare A = Rand_Geo(0.3, R); Show(A)
  #declare A = Rand_Poisson(3, R); Show(A)
  Show(rand(R))
#end
