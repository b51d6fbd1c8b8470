! A steel strip of 1000 x 20 x 10 mm, clamped at the left, as four beams; 1 N at the tip.
!
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
model create  &
   model_name = cantilever
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.ground
!
marker create  &
   marker_name = .cantilever.ground.root  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body name_and_position  &
   part_name = .cantilever.node_1  &
   location = 250.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.node_1
!
marker create  &
   marker_name = .cantilever.node_1.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .cantilever.node_1  &
   mass = 0.39005  &
   center_of_mass_marker = .cantilever.node_1.cm  &
   ixx = 16.2521  &
   iyy = 2034.76  &
   izz = 2044.51
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.ground
!
part create rigid_body name_and_position  &
   part_name = .cantilever.node_2  &
   location = 500.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.node_2
!
marker create  &
   marker_name = .cantilever.node_2.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .cantilever.node_2  &
   mass = 0.39005  &
   center_of_mass_marker = .cantilever.node_2.cm  &
   ixx = 16.2521  &
   iyy = 2034.76  &
   izz = 2044.51
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.ground
!
part create rigid_body name_and_position  &
   part_name = .cantilever.node_3  &
   location = 750.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.node_3
!
marker create  &
   marker_name = .cantilever.node_3.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .cantilever.node_3  &
   mass = 0.39005  &
   center_of_mass_marker = .cantilever.node_3.cm  &
   ixx = 16.2521  &
   iyy = 2034.76  &
   izz = 2044.51
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.ground
!
part create rigid_body name_and_position  &
   part_name = .cantilever.node_4  &
   location = 1000.0, 0.0, 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.node_4
!
marker create  &
   marker_name = .cantilever.node_4.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .cantilever.node_4  &
   mass = 0.195025  &
   center_of_mass_marker = .cantilever.node_4.cm  &
   ixx = 8.12604  &
   iyy = 1017.38  &
   izz = 1022.26
!
defaults coordinate_system  &
   default_coordinate_system = .cantilever.ground
!
force create element_like beam  &
   beam_name = .cantilever.beam_1  &
   i_marker_name = .cantilever.node_1.cm  &
   j_marker_name = .cantilever.ground.root  &
   length = 250.0  &
   area_of_cross_section = 200.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 4580  &
   iyy = 1666.666667  &
   izz = 6666.666667  &
   damping_ratio = 1.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .cantilever.beam_2  &
   i_marker_name = .cantilever.node_2.cm  &
   j_marker_name = .cantilever.node_1.cm  &
   length = 250.0  &
   area_of_cross_section = 200.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 4580  &
   iyy = 1666.666667  &
   izz = 6666.666667  &
   damping_ratio = 1.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .cantilever.beam_3  &
   i_marker_name = .cantilever.node_3.cm  &
   j_marker_name = .cantilever.node_2.cm  &
   length = 250.0  &
   area_of_cross_section = 200.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 4580  &
   iyy = 1666.666667  &
   izz = 6666.666667  &
   damping_ratio = 1.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .cantilever.beam_4  &
   i_marker_name = .cantilever.node_4.cm  &
   j_marker_name = .cantilever.node_3.cm  &
   length = 250.0  &
   area_of_cross_section = 200.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 4580  &
   iyy = 1666.666667  &
   izz = 6666.666667  &
   damping_ratio = 1.0E-03  &
   formulation = linear
!
force create direct single_component_force  &
   single_component_force_name = .cantilever.tip_force  &
   type_of_freedom = translational  &
   action_only = on  &
   i_marker_name = .cantilever.node_4.cm  &
   j_marker_name = .cantilever.ground.root  &
   function = "-1.0"
!
output_control create request  &
   request_name = .cantilever.TIP  &
   output_type = displacement  &
   i_marker_name = .cantilever.node_4.cm  &
   j_marker_name = .cantilever.ground.root  &
   r_marker_name = .cantilever.ground.root
!
output_control create request  &
   request_name = .cantilever.ROOT  &
   output_type = force  &
   i_marker_name = .cantilever.node_1.cm  &
   j_marker_name = .cantilever.ground.root  &
   r_marker_name = .cantilever.ground.root
!
! Equilibrium under the tip force.
simulation single_run equilibrium  &
   model_name = .cantilever
!
! The same strip, twice as thick at the root: one command changes one beam.
force modify element_like beam  &
   beam_name = .cantilever.beam_1  &
   area_of_cross_section = 400.0  &
   iyy = 13333.33333  &
   izz = 13333.33333  &
   ixx = 22560
!
simulation single_run equilibrium  &
   model_name = .cantilever
!
! The tip force taken away after an equilibrium with it: the strip swings.
force modify direct single_component_force  &
   single_component_force_name = .cantilever.tip_force  &
   function = "-STEP(TIME, 0.0, 1.0, 1.0E-06, 0.0)"
!
simulation single_run transient  &
   model_name = .cantilever  &
   type = dynamic  &
   initial_static = yes  &
   end_time = 0.5  &
   number_of_steps = 500
