marker create  marker_name = .m.p."tip, left"  adams_id = 12  &
   location =  &
      (LOC_RELATIVE_TO({6inch, .m.r * 2, -0.5}, .m.ground.base))  &
   orientation = 90.0d, (-ATAN(.m.p.cm.location[1]) ** 2), 0D  &
   visibility = (eval((.m.state==1) ? 'off':"on"))
material create  density = (7801.0(kg/meter**3))  youngs = 210000(newton/mm**2)
group create  objects = .m.left_*, .m.?[abc]{x,y}, ("mass_" // RTOI(eval(i+1)*2))
variable set  variable_name = m3  real = (DET({[1,2],[3,4]})), ((1, 2, 3))
