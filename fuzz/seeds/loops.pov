#declare I = 0;
#while (I < 4)
  #switch (I)
    #case (0) #declare S = "none"; #break
    #range (1, 2) #declare S = "some";
    #case (9) #declare T = S; #break
    #else #declare S = concat("many", str(I, 0, 0))
  #end
  #declare I = I + 1;
#end
union {
  #for (K, 0, 1, 0.25)
    #if (K = 0.5) #break #end
    box { <K, 0, 0>, <K + 0.1, 1, select(K - 0.5, 1, 2, 3)> }
  #end
  sphere { 0, 1 }
}
#ifdef (I) #undef I #else #error "none" #end
#ifndef (I) #local J = mod(7, 4) | 0 & 1; #elseif (0) #end
