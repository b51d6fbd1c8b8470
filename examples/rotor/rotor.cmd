! A two-bladed rotor, driven at 30 rad/s about a vertical axis; three beams a blade.
!
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
model create  &
   model_name = rotor
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
marker create  &
   marker_name = .rotor.ground.axis  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body name_and_position  &
   part_name = .rotor.hub  &
   location = 0.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.hub  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.hub
!
marker create  &
   marker_name = .rotor.hub.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .rotor.hub.blade_1_root  &
   location = 100.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .rotor.hub.blade_2_root  &
   location = -100.0, 0.0, 0.0  &
   orientation = 180.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.hub  &
   mass = 5.0  &
   center_of_mass_marker = .rotor.hub.cm  &
   ixx = 1.0E+04  &
   iyy = 1.0E+04  &
   izz = 2.0E+04
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_1_1  &
   location = 400.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_1_1  &
   vy = 12000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_1_1
!
marker create  &
   marker_name = .rotor.blade_1_1.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_1_1  &
   mass = 1.68502  &
   center_of_mass_marker = .rotor.blade_1_1.cm  &
   ixx = 525.725  &
   iyy = 12657.8  &
   izz = 13143.1
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_1_2  &
   location = 700.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_1_2  &
   vy = 21000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_1_2
!
marker create  &
   marker_name = .rotor.blade_1_2.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_1_2  &
   mass = 1.68502  &
   center_of_mass_marker = .rotor.blade_1_2.cm  &
   ixx = 525.725  &
   iyy = 12657.8  &
   izz = 13143.1
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_1_3  &
   location = 1000.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_1_3  &
   vy = 30000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_1_3
!
marker create  &
   marker_name = .rotor.blade_1_3.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_1_3  &
   mass = 0.842508  &
   center_of_mass_marker = .rotor.blade_1_3.cm  &
   ixx = 262.862  &
   iyy = 6328.92  &
   izz = 6571.56
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_2_1  &
   location = -400.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_2_1  &
   vy = -12000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_2_1
!
marker create  &
   marker_name = .rotor.blade_2_1.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 180.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_2_1  &
   mass = 1.68502  &
   center_of_mass_marker = .rotor.blade_2_1.cm  &
   ixx = 525.725  &
   iyy = 12657.8  &
   izz = 13143.1
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_2_2  &
   location = -700.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_2_2  &
   vy = -21000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_2_2
!
marker create  &
   marker_name = .rotor.blade_2_2.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 180.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_2_2  &
   mass = 1.68502  &
   center_of_mass_marker = .rotor.blade_2_2.cm  &
   ixx = 525.725  &
   iyy = 12657.8  &
   izz = 13143.1
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
part create rigid_body name_and_position  &
   part_name = .rotor.blade_2_3  &
   location = -1000.0, 0.0, 0.0
!
part create rigid_body initial_velocity  &
   part_name = .rotor.blade_2_3  &
   vy = -30000.0  &
   wz = 30.0
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.blade_2_3
!
marker create  &
   marker_name = .rotor.blade_2_3.cm  &
   location = 0.0, 0.0, 0.0  &
   orientation = 180.0d, 0.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .rotor.blade_2_3  &
   mass = 0.842508  &
   center_of_mass_marker = .rotor.blade_2_3.cm  &
   ixx = 262.862  &
   iyy = 6328.92  &
   izz = 6571.56
!
defaults coordinate_system  &
   default_coordinate_system = .rotor.ground
!
force create element_like beam  &
   beam_name = .rotor.blade_1_beam_1  &
   i_marker_name = .rotor.blade_1_1.cm  &
   j_marker_name = .rotor.hub.blade_1_root  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .rotor.blade_1_beam_2  &
   i_marker_name = .rotor.blade_1_2.cm  &
   j_marker_name = .rotor.blade_1_1.cm  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .rotor.blade_1_beam_3  &
   i_marker_name = .rotor.blade_1_3.cm  &
   j_marker_name = .rotor.blade_1_2.cm  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .rotor.blade_2_beam_1  &
   i_marker_name = .rotor.blade_2_1.cm  &
   j_marker_name = .rotor.hub.blade_2_root  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .rotor.blade_2_beam_2  &
   i_marker_name = .rotor.blade_2_2.cm  &
   j_marker_name = .rotor.blade_2_1.cm  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
force create element_like beam  &
   beam_name = .rotor.blade_2_beam_3  &
   i_marker_name = .rotor.blade_2_3.cm  &
   j_marker_name = .rotor.blade_2_2.cm  &
   length = 300.0  &
   area_of_cross_section = 720.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 207000.0  &
   shear_modulus = 80232.55814  &
   ixx = 30170.88  &
   iyy = 8640  &
   izz = 216000  &
   damping_ratio = 5.0E-03  &
   formulation = linear
!
geometry create shape cylinder  &
   cylinder_name = .rotor.hub.drum  &
   center_marker = .rotor.hub.cm  &
   length = 80.0  &
   radius = 100.0  &
   side_count_for_body = 24
!
part attributes  &
   part_name = .rotor.hub  &
   color = GREEN
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_1_1.body  &
   center_marker = .rotor.blade_1_1.cm  &
   x_scale_factor = 300.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_1_2.body  &
   center_marker = .rotor.blade_1_2.cm  &
   x_scale_factor = 300.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_1_3.body  &
   center_marker = .rotor.blade_1_3.cm  &
   x_scale_factor = 150.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_2_1.body  &
   center_marker = .rotor.blade_2_1.cm  &
   x_scale_factor = 300.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_2_2.body  &
   center_marker = .rotor.blade_2_2.cm  &
   x_scale_factor = 300.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
geometry create shape ellipsoid  &
   ellipsoid_name = .rotor.blade_2_3.body  &
   center_marker = .rotor.blade_2_3.cm  &
   x_scale_factor = 150.0  &
   y_scale_factor = 60.0  &
   z_scale_factor = 12.0
!
constraint create joint revolute  &
   joint_name = .rotor.bearing  &
   i_marker_name = .rotor.hub.cm  &
   j_marker_name = .rotor.ground.axis
!
constraint create motion_generator  &
   motion_name = .rotor.drive  &
   joint_name = .rotor.bearing  &
   type_of_freedom = rotational  &
   function = "30.0 * TIME"
!
output_control create request  &
   request_name = .rotor.ROOT_1  &
   output_type = force  &
   i_marker_name = .rotor.blade_1_1.cm  &
   j_marker_name = .rotor.hub.blade_1_root  &
   r_marker_name = .rotor.hub.blade_1_root
!
output_control create request  &
   request_name = .rotor.TIP_1  &
   output_type = displacement  &
   i_marker_name = .rotor.blade_1_3.cm  &
   j_marker_name = .rotor.ground.axis  &
   r_marker_name = .rotor.ground.axis
!
output_control create request  &
   request_name = .rotor.TIP_2  &
   output_type = displacement  &
   i_marker_name = .rotor.blade_2_3.cm  &
   j_marker_name = .rotor.ground.axis  &
   r_marker_name = .rotor.ground.axis
!
simulation single_run transient  &
   model_name = .rotor  &
   type = dynamic  &
   end_time = 2.0  &
   number_of_steps = 400
