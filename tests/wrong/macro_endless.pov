// A macro that calls itself for ever.
#macro Tower(K) box { -1, 1 translate K * y } Tower(K + 1) #end
Tower(0)
