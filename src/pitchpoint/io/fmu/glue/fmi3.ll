; 7d397be2b717737c5dc67226d04ee924f1f365253a1643e5c2203bee03c234a7

%struct.Numbers = type { i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, double, double, double, double }
%struct.Variable = type { i64, i64, i64, double, double, double }
%struct.Place = type { i64, i64, i64, i64, double }
%struct.Callbacks = type { ptr, ptr, ptr, ptr, ptr }
%struct.Instance = type { %struct.Callbacks, ptr, %struct.Clock, ptr, ptr, ptr, ptr, [480 x i8] }
%struct.Clock = type { double, double, i64, i64, i64, i64, i64, i64 }
%struct.Recorder = type { i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64 }

@.str = private unnamed_addr constant [4 x i8] c"3.0\00", align 1
@.str.1 = private unnamed_addr constant [15 x i8] c"logStatusError\00", align 1
@.str.2 = private unnamed_addr constant [51 x i8] c"this model is not exported for scheduled execution\00", align 1
@.str.3 = private unnamed_addr constant [43 x i8] c"the model has no variables of type Float32\00", align 1
@.str.4 = private unnamed_addr constant [40 x i8] c"the model has no variables of type Int8\00", align 1
@.str.5 = private unnamed_addr constant [41 x i8] c"the model has no variables of type UInt8\00", align 1
@.str.6 = private unnamed_addr constant [41 x i8] c"the model has no variables of type Int16\00", align 1
@.str.7 = private unnamed_addr constant [42 x i8] c"the model has no variables of type UInt16\00", align 1
@.str.8 = private unnamed_addr constant [41 x i8] c"the model has no variables of type Int32\00", align 1
@.str.9 = private unnamed_addr constant [42 x i8] c"the model has no variables of type UInt32\00", align 1
@.str.10 = private unnamed_addr constant [41 x i8] c"the model has no variables of type Int64\00", align 1
@.str.11 = private unnamed_addr constant [42 x i8] c"the model has no variables of type UInt64\00", align 1
@.str.12 = private unnamed_addr constant [43 x i8] c"the model has no variables of type Boolean\00", align 1
@.str.13 = private unnamed_addr constant [42 x i8] c"the model has no variables of type String\00", align 1
@.str.14 = private unnamed_addr constant [42 x i8] c"the model has no variables of type Binary\00", align 1
@.str.15 = private unnamed_addr constant [24 x i8] c"the model has no clocks\00", align 1
@pp_numbers = external local_unnamed_addr constant %struct.Numbers, align 8
@.str.16 = private unnamed_addr constant [47 x i8] c"fmi3EnterStepMode is not available in this FMU\00", align 1
@.str.17 = private unnamed_addr constant [56 x i8] c"fmi3EnterConfigurationMode is not available in this FMU\00", align 1
@.str.18 = private unnamed_addr constant [55 x i8] c"fmi3ExitConfigurationMode is not available in this FMU\00", align 1
@.str.19 = private unnamed_addr constant [56 x i8] c"fmi3EvaluateDiscreteStates is not available in this FMU\00", align 1
@.str.20 = private unnamed_addr constant [65 x i8] c"fmi3GetNumberOfVariableDependencies is not available in this FMU\00", align 1
@.str.21 = private unnamed_addr constant [57 x i8] c"fmi3GetVariableDependencies is not available in this FMU\00", align 1
@.str.22 = private unnamed_addr constant [54 x i8] c"fmi3GetAdjointDerivative is not available in this FMU\00", align 1
@.str.23 = private unnamed_addr constant [52 x i8] c"fmi3GetIntervalDecimal is not available in this FMU\00", align 1
@.str.24 = private unnamed_addr constant [53 x i8] c"fmi3GetIntervalFraction is not available in this FMU\00", align 1
@.str.25 = private unnamed_addr constant [49 x i8] c"fmi3GetShiftDecimal is not available in this FMU\00", align 1
@.str.26 = private unnamed_addr constant [50 x i8] c"fmi3GetShiftFraction is not available in this FMU\00", align 1
@.str.27 = private unnamed_addr constant [52 x i8] c"fmi3SetIntervalDecimal is not available in this FMU\00", align 1
@.str.28 = private unnamed_addr constant [53 x i8] c"fmi3SetIntervalFraction is not available in this FMU\00", align 1
@.str.29 = private unnamed_addr constant [49 x i8] c"fmi3SetShiftDecimal is not available in this FMU\00", align 1
@.str.30 = private unnamed_addr constant [50 x i8] c"fmi3SetShiftFraction is not available in this FMU\00", align 1
@.str.31 = private unnamed_addr constant [54 x i8] c"fmi3GetOutputDerivatives is not available in this FMU\00", align 1
@.str.32 = private unnamed_addr constant [56 x i8] c"fmi3ActivateModelPartition is not available in this FMU\00", align 1
@pp_token = external local_unnamed_addr constant [0 x i8], align 1
@.str.33 = private unnamed_addr constant [68 x i8] c"the identifier in the model description is not that of this library\00", align 1
@.str.34 = private unnamed_addr constant [61 x i8] c"this library needs a processor with AVX2 and FMA (x86-64-v3)\00", align 1
@.str.35 = private unnamed_addr constant [46 x i8] c"this model is exported for co-simulation only\00", align 1
@.str.36 = private unnamed_addr constant [26 x i8] c"no memory for an instance\00", align 1
@.str.37 = private unnamed_addr constant [17 x i8] c"logStatusWarning\00", align 1
@.str.38 = private unnamed_addr constant [68 x i8] c"the start time is set before the initialisation; reset the instance\00", align 1
@.str.39 = private unnamed_addr constant [39 x i8] c"the stop time is before the start time\00", align 1
@.str.40 = private unnamed_addr constant [29 x i8] c"the start time is not finite\00", align 1
@.str.41 = private unnamed_addr constant [95 x i8] c"the start time must be that of the model description: drives prescribe positions over the time\00", align 1
@pp_variables = external local_unnamed_addr constant [0 x %struct.Variable], align 8
@pp_places = external constant [0 x %struct.Place], align 8
@.str.42 = private unnamed_addr constant [56 x i8] c"the initialisation has begun before; reset the instance\00", align 1
@.str.43 = private unnamed_addr constant [54 x i8] c"the initialisation has not begun, or has ended before\00", align 1
@pp_balancing = external local_unnamed_addr constant [0 x i32], align 4
@pp_free = external constant [0 x i32], align 4
@.str.44 = private unnamed_addr constant [111 x i8] c"no equilibrium was found for these inputs and parameters: the run starts in the state of the model description\00", align 1
@.str.45 = private unnamed_addr constant [112 x i8] c"the balancing torques are means without the instants that have no equilibrium, such as those at a missing tooth\00", align 1
@pp_entries = external local_unnamed_addr constant [0 x ptr], align 8
@pp_free_balancing = external constant [0 x i32], align 4
@pp_instants = external local_unnamed_addr constant [0 x double], align 8
@pp_spins = external local_unnamed_addr constant [0 x i32], align 4
@pp_coefficients = external local_unnamed_addr constant [0 x double], align 8
@pp_extents = external local_unnamed_addr constant [0 x double], align 8
@pp_entries_of_matrix = external local_unnamed_addr constant [0 x i32], align 4
@pp_gaps = external local_unnamed_addr constant [0 x i32], align 4
@pp_depths = external local_unnamed_addr constant [0 x double], align 8
@.str.46 = private unnamed_addr constant [31 x i8] c"the forces cannot be evaluated\00", align 1
@.str.47 = private unnamed_addr constant [28 x i8] c"check inputs and parameters\00", align 1
@pp_n_sentences = external local_unnamed_addr constant i64, align 8
@.str.48 = private unnamed_addr constant [3 x i8] c": \00", align 1
@pp_sentences = external local_unnamed_addr constant [0 x ptr], align 8
@.str.49 = private unnamed_addr constant [3 x i8] c"; \00", align 1
@.str.50 = private unnamed_addr constant [57 x i8] c"only an initialised instance can be terminated, and once\00", align 1
@pp_image = external constant [0 x i64], align 8
@pp_code = external local_unnamed_addr constant [0 x i32], align 4
@pp_moved = external local_unnamed_addr constant [0 x i32], align 4
@.str.51 = private unnamed_addr constant [53 x i8] c"the numbers of values and of value references differ\00", align 1
@.str.52 = private unnamed_addr constant [65 x i8] c"no variable with a floating-point value has this value reference\00", align 1
@pp_indicators = external local_unnamed_addr constant [0 x i32], align 4
@.str.53 = private unnamed_addr constant [75 x i8] c"coordinates and rates can be set before the end of the initialisation only\00", align 1
@.str.54 = private unnamed_addr constant [50 x i8] c"this variable is neither an input nor a parameter\00", align 1
@.str.55 = private unnamed_addr constant [36 x i8] c"an input or parameter is not finite\00", align 1
@.str.56 = private unnamed_addr constant [53 x i8] c"a parameter is out of the range in its description: \00", align 1
@.str.57 = private unnamed_addr constant [11 x i8] c" is below \00", align 1
@.str.58 = private unnamed_addr constant [1 x i8] zeroinitializer, align 1
@.str.59 = private unnamed_addr constant [11 x i8] c" is above \00", align 1
@.str.60 = private unnamed_addr constant [25 x i8] c"infinite or not a number\00", align 1
@.str.61 = private unnamed_addr constant [32 x i8] c"no place for the state is given\00", align 1
@.str.62 = private unnamed_addr constant [22 x i8] c"no memory for a state\00", align 1
@.str.63 = private unnamed_addr constant [18 x i8] c"no state is given\00", align 1
@.str.64 = private unnamed_addr constant [34 x i8] c"this state is that of another FMU\00", align 1
@.str.65 = private unnamed_addr constant [70 x i8] c"the buffer is smaller than the serialised state, or no state is given\00", align 1
@.str.66 = private unnamed_addr constant [63 x i8] c"these bytes are not a state of this FMU: their number is wrong\00", align 1
@.str.67 = private unnamed_addr constant [39 x i8] c"these bytes are a state of another FMU\00", align 1
@.str.68 = private unnamed_addr constant [60 x i8] c"directional derivatives are for instances of model exchange\00", align 1
@.str.69 = private unnamed_addr constant [53 x i8] c"a known is neither a state nor an input or parameter\00", align 1
@.str.70 = private unnamed_addr constant [21 x i8] c"a seed is not finite\00", align 1
@.str.71 = private unnamed_addr constant [38 x i8] c"no memory for directional derivatives\00", align 1
@.str.72 = private unnamed_addr constant [36 x i8] c"this instance is for model exchange\00", align 1
@.str.73 = private unnamed_addr constant [42 x i8] c"the run is terminated; reset the instance\00", align 1
@.str.74 = private unnamed_addr constant [70 x i8] c"the initialisation has not ended; a communication step comes after it\00", align 1
@.str.75 = private unnamed_addr constant [65 x i8] c"the run has failed before; reset the instance or restore a state\00", align 1
@.str.76 = private unnamed_addr constant [40 x i8] c"the communication step must be positive\00", align 1
@.str.77 = private unnamed_addr constant [25 x i8] c"the communication point \00", align 1
@.str.78 = private unnamed_addr constant [34 x i8] c" s is not the time of the model, \00", align 1
@.str.79 = private unnamed_addr constant [3 x i8] c" s\00", align 1
@.str.80 = private unnamed_addr constant [53 x i8] c"the communication step has more than 1e15 time steps\00", align 1
@.str.81 = private unnamed_addr constant [15 x i8] c"the run failed\00", align 1
@.str.82 = private unnamed_addr constant [67 x i8] c"export it with a shorter time step, or check inputs and parameters\00", align 1
@.str.83 = private unnamed_addr constant [70 x i8] c"the event mode follows the initialisation or the continuous-time mode\00", align 1
@.str.84 = private unnamed_addr constant [73 x i8] c"this instance is for co-simulation, and this function for model exchange\00", align 1
@.str.85 = private unnamed_addr constant [46 x i8] c"discrete states are updated in the event mode\00", align 1
@.str.86 = private unnamed_addr constant [48 x i8] c"the continuous-time mode follows the event mode\00", align 1
@.str.87 = private unnamed_addr constant [59 x i8] c"integrator steps are completed in the continuous-time mode\00", align 1
@.str.88 = private unnamed_addr constant [68 x i8] c"the time is set after the initialisation and before the termination\00", align 1
@.str.89 = private unnamed_addr constant [23 x i8] c"the time is not finite\00", align 1
@.str.90 = private unnamed_addr constant [43 x i8] c"states are set in the continuous-time mode\00", align 1
@.str.91 = private unnamed_addr constant [22 x i8] c"a state is not finite\00", align 1
@.str.92 = private unnamed_addr constant [72 x i8] c"the number of states or indicators is not that of the model description\00", align 1
@early = internal constant [91 x i8] c"states, derivatives and event indicators are known from the begin of the initialisation on\00", align 16
@.str.93 = private unnamed_addr constant [38 x i8] c"the accelerations cannot be evaluated\00", align 1
@.str.94 = private unnamed_addr constant [36 x i8] c"check states, inputs and parameters\00", align 1

define ptr @fmi3GetVersion() local_unnamed_addr #0 {
  ret ptr @.str
}

define i32 @fmi3SetDebugLogging(ptr readnone %0, i1 zeroext %1, i64 %2, ptr readnone %3) local_unnamed_addr #0 {
  ret i32 0
}

define ptr @fmi3InstantiateCoSimulation(ptr %0, ptr %1, ptr readnone %2, i1 zeroext %3, i1 zeroext %4, i1 zeroext %5, i1 zeroext %6, ptr readnone %7, i64 %8, ptr %9, ptr %10, ptr readnone %11) local_unnamed_addr #1 {
  %13 = tail call fastcc ptr @instantiate(ptr %0, ptr %1, ptr %9, ptr %10, i32 0) #17
  ret ptr %13
}

define internal fastcc ptr @instantiate(ptr %0, ptr %1, ptr %2, ptr %3, i32 %4) unnamed_addr #1 {
  %6 = alloca %struct.Callbacks, align 8
  store ptr %3, ptr %6, align 8
  %7 = getelementptr inbounds i8, ptr %6, i64 8
  store ptr null, ptr %7, align 8
  %8 = getelementptr inbounds i8, ptr %6, i64 16
  store ptr null, ptr %8, align 8
  %9 = getelementptr inbounds i8, ptr %6, i64 24
  store ptr null, ptr %9, align 8
  %10 = getelementptr inbounds i8, ptr %6, i64 32
  store ptr %2, ptr %10, align 8
  %11 = call fastcc ptr @create(ptr %0, ptr %1, ptr %6, i32 %4) #17
  ret ptr %11
}

define ptr @fmi3InstantiateModelExchange(ptr %0, ptr %1, ptr readnone %2, i1 zeroext %3, i1 zeroext %4, ptr %5, ptr %6) local_unnamed_addr #1 {
  %8 = tail call fastcc ptr @instantiate(ptr %0, ptr %1, ptr %5, ptr %6, i32 1) #17
  ret ptr %8
}

define noalias ptr @fmi3InstantiateScheduledExecution(ptr readnone %0, ptr readnone %1, ptr readnone %2, i1 zeroext %3, i1 zeroext %4, ptr %5, ptr %6, ptr readnone %7, ptr readnone %8, ptr readnone %9) local_unnamed_addr #1 {
  %11 = icmp eq ptr %6, null
  br i1 %11, label %13, label %12

12:
  tail call void %6(ptr %5, i32 3, ptr @.str.1, ptr @.str.2) #19
  br label %13

13:
  ret ptr null
}

define void @fmi3FreeInstance(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @free_instance(ptr %0) #17
  ret void
}

define internal fastcc void @free_instance(ptr %0) unnamed_addr #1 {
  %2 = alloca %struct.Callbacks, align 8
  %3 = icmp eq ptr %0, null
  br i1 %3, label %5, label %4

4:
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 dereferenceable(40) %2, ptr align 8 dereferenceable(40) %0, i64 40, i1 false)
  call fastcc void @release(ptr %2, ptr %0) #17
  br label %5

5:
  ret void
}

define i32 @fmi3EnterInitializationMode(ptr %0, i1 zeroext %1, double %2, double %3, i1 zeroext %4, double %5) local_unnamed_addr #1 {
  %7 = zext i1 %4 to i32
  %8 = tail call fastcc i32 @set_start(ptr %0, double %3, i32 %7, double %5) #17
  %9 = icmp eq i32 %8, 0
  br i1 %9, label %10, label %12

10:
  %11 = tail call fastcc i32 @enter(ptr %0) #17
  br label %12

12:
  %13 = phi i32 [ %11, %10 ], [ %8, %6 ]
  ret i32 %13
}


define internal fastcc i32 @set_start(ptr %0, double %1, i32 %2, double %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 48
  %6 = getelementptr inbounds i8, ptr %0, i64 104
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %7, 0
  br i1 %8, label %9, label %48

9:
  %10 = icmp ne i32 %2, 0
  %11 = fcmp ult double %3, %1
  %12 = and i1 %10, %11
  br i1 %12, label %48, label %13

13:
  %14 = tail call fastcc i32 @finite_number(double %1) #17
  %15 = icmp eq i32 %14, 0
  br i1 %15, label %48, label %16

16:
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 392), align 8
  %18 = icmp ne i64 %17, 0
  %19 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 400), align 8
  %20 = fcmp une double %1, %19
  %21 = select i1 %18, i1 %20, i1 false
  br i1 %21, label %48, label %22

22:
  store double %1, ptr %5, align 8
  %23 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %23, align 8
  %24 = fcmp oeq double %1, %19
  br i1 %24, label %50, label %25

25:
  %26 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %26, align 8
  %27 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %28 = icmp ne i64 %27, 0
  %29 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %30 = icmp sgt i64 %29, 0
  %31 = select i1 %28, i1 %30, i1 false
  br i1 %31, label %32, label %50

32:
  %33 = phi i64 [ %46, %45 ], [ 0, %25 ]
  %34 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = icmp eq i64 %35, 7
  br i1 %36, label %37, label %45

37:
  %38 = tail call fastcc ptr @drive_of(ptr %0, i64 %33) #17
  %39 = getelementptr inbounds i8, ptr %38, i64 96
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds i8, ptr %38, i64 104
  %42 = load double, ptr %41, align 8
  %43 = fmul double %19, %42
  %44 = fadd double %40, %43
  tail call fastcc void @turn_on(ptr %0, ptr %38, double %44, double %42, double 0.000000e+00) #17
  br label %45

45:
  %46 = add nuw nsw i64 %33, 1
  %47 = icmp slt i64 %46, %29
  br i1 %47, label %32, label %50

48:
  %49 = phi ptr [ @.str.40, %13 ], [ @.str.39, %9 ], [ @.str.38, %4 ], [ @.str.41, %16 ]
  tail call fastcc void @fail(ptr %0, ptr %49) #17
  br label %50

50:
  %51 = phi i32 [ 0, %22 ], [ 3, %48 ], [ 0, %25 ], [ 0, %45 ]
  ret i32 %51
}

define internal fastcc i32 @enter(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = icmp eq i64 %3, 0
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @fail(ptr %0, ptr @.str.42) #17
  br label %7

6:
  store i64 1, ptr %2, align 8
  br label %7

7:
  %8 = phi i32 [ 3, %5 ], [ 0, %6 ]
  ret i32 %8
}


define i32 @fmi3ExitInitializationMode(ptr %0) local_unnamed_addr #1 {
  %2 = tail call fastcc i32 @end_start(ptr %0) #17
  ret i32 %2
}

define internal fastcc i32 @end_start(ptr %0) unnamed_addr #1 {
  %2 = alloca i64, align 8
  %3 = getelementptr inbounds i8, ptr %0, i64 104
  %4 = load i64, ptr %3, align 8
  %5 = icmp eq i64 %4, 1
  br i1 %5, label %7, label %6

6:
  tail call fastcc void @fail(ptr %0, ptr @.str.43) #17
  br label %106

7:
  %8 = getelementptr inbounds i8, ptr %0, i64 96
  %9 = load i64, ptr %8, align 8
  %10 = icmp eq i64 %9, 1
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 56), align 8
  %12 = icmp ne i64 %11, 0
  %13 = select i1 %10, i1 %12, i1 false
  br i1 %13, label %14, label %101

14:
  store i64 0, ptr %2, align 8
  %15 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 72), align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %45

17:
  %18 = getelementptr inbounds i8, ptr %0, i64 112
  %19 = load ptr, ptr %18, align 8
  %20 = and i64 %15, 1
  %21 = icmp eq i64 %15, 1
  br i1 %21, label %26, label %22

22:
  %23 = and i64 %15, 9223372036854775806
  br label %49

24:
  %25 = icmp eq i64 %20, 0
  br i1 %25, label %42, label %26

26:
  %27 = phi i32 [ 1, %17 ], [ %76, %24 ]
  %28 = phi i64 [ 0, %17 ], [ %77, %24 ]
  %29 = icmp ne i64 %20, 0
  tail call void @llvm.assume(i1 %29)
  %30 = shl nuw nsw i64 %28, 3
  %31 = getelementptr inbounds i8, ptr @pp_balancing, i64 %30
  %32 = getelementptr inbounds i8, ptr %31, i64 4
  %33 = load i32, ptr %32, align 4
  %34 = zext i32 %33 to i64
  %35 = getelementptr inbounds double, ptr %19, i64 %34
  %36 = load double, ptr %35, align 8
  %37 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %34
  %38 = getelementptr inbounds i8, ptr %37, i64 24
  %39 = load double, ptr %38, align 8
  %40 = fcmp une double %36, %39
  %41 = select i1 %40, i32 0, i32 %27
  br label %42

42:
  %43 = phi i32 [ %76, %24 ], [ %41, %26 ]
  %44 = icmp ne i32 %43, 0
  br label %45

45:
  %46 = phi i1 [ true, %14 ], [ %44, %42 ]
  %47 = icmp ne i64 %15, 0
  %48 = select i1 %47, i1 %46, i1 false
  br i1 %48, label %80, label %83

49:
  %50 = phi i32 [ 1, %22 ], [ %76, %49 ]
  %51 = phi i64 [ 0, %22 ], [ %77, %49 ]
  %52 = phi i64 [ 0, %22 ], [ %78, %49 ]
  %53 = shl nuw nsw i64 %51, 3
  %54 = getelementptr inbounds i8, ptr @pp_balancing, i64 %53
  %55 = getelementptr inbounds i8, ptr %54, i64 4
  %56 = load i32, ptr %55, align 4
  %57 = zext i32 %56 to i64
  %58 = getelementptr inbounds double, ptr %19, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %57
  %61 = getelementptr inbounds i8, ptr %60, i64 24
  %62 = load double, ptr %61, align 8
  %63 = fcmp une double %59, %62
  %64 = shl i64 %51, 3
  %65 = getelementptr inbounds i8, ptr @pp_balancing, i64 %64
  %66 = getelementptr inbounds i8, ptr %65, i64 12
  %67 = load i32, ptr %66, align 4
  %68 = zext i32 %67 to i64
  %69 = getelementptr inbounds double, ptr %19, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %68
  %72 = getelementptr inbounds i8, ptr %71, i64 24
  %73 = load double, ptr %72, align 8
  %74 = fcmp une double %70, %73
  %75 = select i1 %74, i1 true, i1 %63
  %76 = select i1 %75, i32 0, i32 %50
  %77 = add nuw nsw i64 %51, 2
  %78 = add i64 %52, 2
  %79 = icmp eq i64 %78, %23
  br i1 %79, label %24, label %49

80:
  %81 = call fastcc i32 @balance(ptr %0, ptr %2) #17
  %82 = icmp eq i32 %81, 0
  br i1 %82, label %89, label %83

83:
  %84 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free, i64 %11) #17
  %85 = icmp eq i32 %84, 0
  br i1 %85, label %89, label %86

86:
  %87 = load i64, ptr %2, align 8
  %88 = icmp eq i64 %87, 0
  br i1 %88, label %91, label %89

89:
  %90 = phi ptr [ @.str.44, %80 ], [ @.str.44, %83 ], [ @.str.45, %86 ]
  tail call fastcc void @say(ptr %0, i32 1, ptr %90) #17
  br label %91

91:
  %92 = phi i32 [ 0, %86 ], [ 1, %89 ]
  %93 = getelementptr inbounds i8, ptr %0, i64 136
  %94 = load ptr, ptr %93, align 8
  %95 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %96 = getelementptr inbounds i8, ptr %94, i64 %95
  %97 = load ptr, ptr getelementptr inbounds (i8, ptr @pp_entries, i64 8), align 8
  %98 = tail call fastcc i64 @address(ptr %96) #17
  %99 = tail call i64 %97(i64 %98, i64 5, i64 0) #19
  %100 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %100, align 8
  br label %101

101:
  %102 = phi i32 [ %92, %91 ], [ 0, %7 ]
  %103 = tail call fastcc i32 @refresh(ptr %0) #17
  %104 = icmp eq i32 %103, 0
  br i1 %104, label %105, label %106

105:
  store i64 3, ptr %8, align 8
  store i64 2, ptr %3, align 8
  br label %106

106:
  %107 = phi i32 [ 3, %6 ], [ %102, %105 ], [ %103, %101 ]
  ret i32 %107
}

define i32 @fmi3Terminate(ptr %0) local_unnamed_addr #1 {
  %2 = tail call fastcc i32 @terminate(ptr %0) #17
  ret i32 %2
}

define internal fastcc i32 @terminate(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 104
  %3 = load i64, ptr %2, align 8
  %4 = and i64 %3, -2
  %5 = icmp eq i64 %4, 2
  br i1 %5, label %7, label %6

6:
  tail call fastcc void @fail(ptr %0, ptr @.str.50) #17
  br label %8

7:
  store i64 4, ptr %2, align 8
  br label %8

8:
  %9 = phi i32 [ 3, %6 ], [ 0, %7 ]
  ret i32 %9
}

define i32 @fmi3Reset(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @begin(ptr %0) #17
  ret i32 0
}

define internal fastcc void @begin(ptr %0) unnamed_addr #1 {
  tail call fastcc void @relocate(ptr %0, ptr @pp_image) #17
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %3 = icmp sgt i64 %2, 0
  br i1 %3, label %4, label %26

4:
  %5 = getelementptr inbounds i8, ptr %0, i64 112
  %6 = and i64 %2, 3
  %7 = icmp ult i64 %2, 4
  br i1 %7, label %12, label %8

8:
  %9 = and i64 %2, 9223372036854775804
  br label %34

10:
  %11 = icmp eq i64 %6, 0
  br i1 %11, label %26, label %12

12:
  %13 = phi i64 [ 0, %4 ], [ %60, %10 ]
  %14 = icmp ne i64 %6, 0
  tail call void @llvm.assume(i1 %14)
  br label %15

15:
  %16 = phi i64 [ %13, %12 ], [ %23, %15 ]
  %17 = phi i64 [ 0, %12 ], [ %24, %15 ]
  %18 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %16
  %19 = getelementptr inbounds i8, ptr %18, i64 24
  %20 = load double, ptr %19, align 8
  %21 = load ptr, ptr %5, align 8
  %22 = getelementptr inbounds double, ptr %21, i64 %16
  store double %20, ptr %22, align 8
  %23 = add nuw nsw i64 %16, 1
  %24 = add i64 %17, 1
  %25 = icmp eq i64 %24, %6
  br i1 %25, label %26, label %15

26:
  %27 = getelementptr inbounds i8, ptr %0, i64 48
  %28 = load <2 x double>, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 400), align 8
  store <2 x double> %28, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %29, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 1, ptr %30, align 8
  %31 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 0, ptr %31, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 96
  store i64 0, ptr %32, align 8
  %33 = getelementptr inbounds i8, ptr %0, i64 104
  store i64 0, ptr %33, align 8
  ret void

34:
  %35 = phi i64 [ 0, %8 ], [ %60, %34 ]
  %36 = phi i64 [ 0, %8 ], [ %61, %34 ]
  %37 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %35
  %38 = getelementptr inbounds i8, ptr %37, i64 24
  %39 = load double, ptr %38, align 8
  %40 = load ptr, ptr %5, align 8
  %41 = getelementptr inbounds double, ptr %40, i64 %35
  store double %39, ptr %41, align 8
  %42 = or i64 %35, 1
  %43 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %42
  %44 = getelementptr inbounds i8, ptr %43, i64 24
  %45 = load double, ptr %44, align 8
  %46 = load ptr, ptr %5, align 8
  %47 = getelementptr inbounds double, ptr %46, i64 %42
  store double %45, ptr %47, align 8
  %48 = or i64 %35, 2
  %49 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %48
  %50 = getelementptr inbounds i8, ptr %49, i64 24
  %51 = load double, ptr %50, align 8
  %52 = load ptr, ptr %5, align 8
  %53 = getelementptr inbounds double, ptr %52, i64 %48
  store double %51, ptr %53, align 8
  %54 = or i64 %35, 3
  %55 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %54
  %56 = getelementptr inbounds i8, ptr %55, i64 24
  %57 = load double, ptr %56, align 8
  %58 = load ptr, ptr %5, align 8
  %59 = getelementptr inbounds double, ptr %58, i64 %54
  store double %57, ptr %59, align 8
  %60 = add nuw nsw i64 %35, 4
  %61 = add i64 %36, 4
  %62 = icmp eq i64 %61, %9
  br i1 %62, label %10, label %34
}

define i32 @fmi3GetFloat64(ptr %0, ptr %1, i64 %2, ptr %3, i64 %4) local_unnamed_addr #1 {
  %6 = tail call fastcc i32 @agree(ptr %0, i64 %2, i64 %4) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %10, label %8

8:
  %9 = tail call fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %3) #17
  br label %10

10:
  %11 = phi i32 [ %9, %8 ], [ 3, %5 ]
  ret i32 %11
}

define internal fastcc i32 @agree(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = icmp eq i64 %1, %2
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @fail(ptr %0, ptr @.str.51) #17
  br label %6

6:
  %7 = zext i1 %4 to i32
  ret i32 %7
}

define internal fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #1 {
  %5 = icmp eq i64 %2, 0
  br i1 %5, label %72, label %6

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 136
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 248), align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 112
  %11 = getelementptr inbounds i8, ptr %0, i64 120
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  br label %15

15:
  %16 = phi i64 [ 0, %6 ], [ %70, %67 ]
  %17 = getelementptr inbounds i32, ptr %1, i64 %16
  %18 = load i32, ptr %17, align 4
  %19 = zext i32 %18 to i64
  %20 = icmp sgt i64 %7, %19
  br i1 %20, label %22, label %21

21:
  tail call fastcc void @fail(ptr %0, ptr @.str.52) #17
  br label %72

22:
  %23 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %19
  %24 = load i64, ptr %23, align 8
  switch i64 %24, label %46 [
    i64 5, label %25
    i64 1, label %27
    i64 2, label %27
    i64 7, label %27
    i64 8, label %27
    i64 6, label %31
  ]

25:
  %26 = tail call fastcc double @now(ptr %0) #17
  br label %67

27:
  %28 = load ptr, ptr %10, align 8
  %29 = getelementptr inbounds double, ptr %28, i64 %19
  %30 = load double, ptr %29, align 8
  br label %67

31:
  %32 = load ptr, ptr %8, align 8
  %33 = getelementptr inbounds i8, ptr %32, i64 %9
  %34 = tail call fastcc i64 @address(ptr %33) #17
  %35 = tail call fastcc i64 @request(ptr %0, i64 3, i64 %34) #17
  %36 = icmp eq i64 %35, 1
  br i1 %36, label %37, label %72

37:
  %38 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %39 = getelementptr inbounds i8, ptr %23, i64 8
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr inbounds i32, ptr @pp_indicators, i64 %40
  %42 = load i32, ptr %41, align 4
  %43 = zext i32 %42 to i64
  %44 = getelementptr inbounds double, ptr %38, i64 %43
  %45 = load double, ptr %44, align 8
  br label %67

46:
  %47 = tail call fastcc i32 @refresh(ptr %0) #17
  %48 = icmp eq i32 %47, 0
  br i1 %48, label %49, label %72

49:
  %50 = getelementptr inbounds i8, ptr %23, i64 8
  %51 = load i64, ptr %50, align 8
  switch i64 %24, label %59 [
    i64 0, label %52
    i64 3, label %56
  ]

52:
  %53 = load ptr, ptr %11, align 8
  %54 = getelementptr inbounds double, ptr %53, i64 %51
  %55 = load double, ptr %54, align 8
  br label %67

56:
  %57 = tail call fastcc ptr @state_at(ptr %0, i64 %51) #17
  %58 = load double, ptr %57, align 8
  br label %67

59:
  %60 = icmp slt i64 %51, %12
  %61 = select i1 %60, i64 %13, i64 %14
  %62 = tail call fastcc ptr @reals(ptr %0, i64 %61) #17
  %63 = select i1 %60, i64 0, i64 %12
  %64 = sub nsw i64 %51, %63
  %65 = getelementptr inbounds double, ptr %62, i64 %64
  %66 = load double, ptr %65, align 8
  br label %67

67:
  %68 = phi double [ %26, %25 ], [ %30, %27 ], [ %45, %37 ], [ %58, %56 ], [ %66, %59 ], [ %55, %52 ]
  %69 = getelementptr inbounds double, ptr %3, i64 %16
  store double %68, ptr %69, align 8
  %70 = add nuw i64 %16, 1
  %71 = icmp eq i64 %70, %2
  br i1 %71, label %72, label %15

72:
  %73 = phi i32 [ 3, %21 ], [ 0, %4 ], [ %47, %46 ], [ 0, %67 ], [ 2, %31 ]
  ret i32 %73
}

define i32 @fmi3SetFloat64(ptr %0, ptr %1, i64 %2, ptr %3, i64 %4) local_unnamed_addr #1 {
  %6 = tail call fastcc i32 @agree(ptr %0, i64 %2, i64 %4) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %10, label %8

8:
  %9 = tail call fastcc i32 @set_numbers(ptr %0, ptr %1, i64 %2, ptr %3) #17
  br label %10

10:
  %11 = phi i32 [ %9, %8 ], [ 3, %5 ]
  ret i32 %11
}

define internal fastcc i32 @set_numbers(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #1 {
  %5 = icmp eq i64 %2, 0
  br i1 %5, label %95, label %6

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 96
  br label %18

9:
  %10 = add nuw i64 %19, 1
  %11 = icmp eq i64 %10, %2
  br i1 %11, label %12, label %18

12:
  %13 = getelementptr inbounds i8, ptr %0, i64 112
  %14 = getelementptr inbounds i8, ptr %0, i64 96
  %15 = getelementptr inbounds i8, ptr %0, i64 88
  %16 = getelementptr inbounds i8, ptr %0, i64 72
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  br label %48

18:
  %19 = phi i64 [ 0, %6 ], [ %10, %9 ]
  %20 = getelementptr inbounds i32, ptr %1, i64 %19
  %21 = load i32, ptr %20, align 4
  %22 = zext i32 %21 to i64
  %23 = icmp sgt i64 %7, %22
  br i1 %23, label %24, label %31

24:
  %25 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %22
  %26 = load i64, ptr %25, align 8
  switch i64 %26, label %32 [
    i64 3, label %27
    i64 6, label %31
    i64 5, label %31
    i64 4, label %31
    i64 0, label %31
  ]

27:
  %28 = load i64, ptr %8, align 8
  %29 = icmp eq i64 %28, 3
  br i1 %29, label %30, label %32

30:
  tail call fastcc void @fail(ptr %0, ptr @.str.53) #17
  br label %95

31:
  tail call fastcc void @fail(ptr %0, ptr @.str.54) #17
  br label %95

32:
  %33 = getelementptr inbounds double, ptr %3, i64 %19
  %34 = load double, ptr %33, align 8
  %35 = tail call fastcc i32 @finite_number(double %34) #17
  %36 = icmp eq i32 %35, 0
  br i1 %36, label %37, label %38

37:
  tail call fastcc void @fail(ptr %0, ptr @.str.55) #17
  br label %95

38:
  %39 = getelementptr inbounds i8, ptr %25, i64 32
  %40 = load double, ptr %39, align 8
  %41 = fcmp olt double %34, %40
  br i1 %41, label %42, label %43

42:
  tail call fastcc void @fail_with(ptr %0, ptr @.str.56, double %34, ptr @.str.57, double %40, ptr @.str.58) #17
  br label %95

43:
  %44 = getelementptr inbounds i8, ptr %25, i64 40
  %45 = load double, ptr %44, align 8
  %46 = fcmp ogt double %34, %45
  br i1 %46, label %47, label %9

47:
  tail call fastcc void @fail_with(ptr %0, ptr @.str.56, double %34, ptr @.str.59, double %45, ptr @.str.58) #17
  br label %95

48:
  %49 = phi i64 [ 0, %12 ], [ %93, %92 ]
  %50 = getelementptr inbounds i32, ptr %1, i64 %49
  %51 = load i32, ptr %50, align 4
  %52 = zext i32 %51 to i64
  %53 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %52
  %54 = load i64, ptr %53, align 8
  %55 = icmp eq i64 %54, 3
  br i1 %55, label %56, label %71

56:
  %57 = getelementptr inbounds i8, ptr %53, i64 8
  %58 = load i64, ptr %57, align 8
  %59 = tail call fastcc ptr @state_at(ptr %0, i64 %58) #17
  %60 = load double, ptr %59, align 8
  %61 = getelementptr inbounds double, ptr %3, i64 %49
  %62 = load double, ptr %61, align 8
  %63 = fcmp oeq double %60, %62
  br i1 %63, label %92, label %64

64:
  store double %62, ptr %59, align 8
  store i64 2, ptr %16, align 8
  %65 = icmp slt i64 %58, %17
  br i1 %65, label %66, label %67

66:
  store i64 2, ptr %14, align 8
  br label %92

67:
  %68 = load i64, ptr %14, align 8
  %69 = icmp eq i64 %68, 0
  br i1 %69, label %70, label %92

70:
  store i64 1, ptr %14, align 8
  br label %92

71:
  %72 = load ptr, ptr %13, align 8
  %73 = getelementptr inbounds double, ptr %72, i64 %52
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds double, ptr %3, i64 %49
  %76 = load double, ptr %75, align 8
  %77 = fcmp oeq double %74, %76
  br i1 %77, label %92, label %78

78:
  store double %76, ptr %73, align 8
  %79 = load i64, ptr %14, align 8
  %80 = icmp eq i64 %79, 0
  br i1 %80, label %81, label %82

81:
  store i64 1, ptr %14, align 8
  br label %82

82:
  %83 = add i64 %54, -1
  %84 = icmp ult i64 %83, 2
  br i1 %84, label %85, label %88

85:
  %86 = load i32, ptr %50, align 4
  %87 = zext i32 %86 to i64
  tail call fastcc void @put(ptr %0, i64 %87) #17
  br label %91

88:
  %89 = load i64, ptr %15, align 8
  %90 = icmp eq i64 %89, 0
  br i1 %90, label %92, label %91

91:
  store i64 2, ptr %16, align 8
  br label %92

92:
  %93 = add nuw i64 %49, 1
  %94 = icmp eq i64 %93, %2
  br i1 %94, label %95, label %48

95:
  %96 = phi i32 [ 3, %30 ], [ 3, %47 ], [ 3, %42 ], [ 3, %37 ], [ 3, %31 ], [ 0, %4 ], [ 0, %92 ]
  ret i32 %96
}

define i32 @fmi3GetFloat32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.3) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define internal fastcc void @fail(ptr %0, ptr %1) unnamed_addr #1 {
  tail call fastcc void @say(ptr %0, i32 3, ptr %1) #17
  ret void
}

define i32 @fmi3SetFloat32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.3) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetInt8(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.4) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetInt8(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.4) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetUInt8(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.5) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetUInt8(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.5) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetInt16(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.6) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetInt16(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.6) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetUInt16(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.7) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetUInt16(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.7) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetInt32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.8) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetInt32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.8) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetUInt32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.9) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetUInt32(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.9) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetInt64(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.10) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetInt64(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.10) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetUInt64(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.11) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetUInt64(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.11) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetBoolean(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.12) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetBoolean(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.12) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetString(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.13) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3SetString(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4) local_unnamed_addr #1 {
  %6 = icmp eq i64 %2, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.13) #17
  br label %8

8:
  %9 = phi i32 [ 3, %7 ], [ 0, %5 ]
  ret i32 %9
}

define i32 @fmi3GetBinary(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4, i64 %5) local_unnamed_addr #1 {
  %7 = icmp eq i64 %2, 0
  br i1 %7, label %9, label %8

8:
  tail call fastcc void @fail(ptr %0, ptr @.str.14) #17
  br label %9

9:
  %10 = phi i32 [ 3, %8 ], [ 0, %6 ]
  ret i32 %10
}

define i32 @fmi3SetBinary(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4, i64 %5) local_unnamed_addr #1 {
  %7 = icmp eq i64 %2, 0
  br i1 %7, label %9, label %8

8:
  tail call fastcc void @fail(ptr %0, ptr @.str.14) #17
  br label %9

9:
  %10 = phi i32 [ 3, %8 ], [ 0, %6 ]
  ret i32 %10
}

define i32 @fmi3GetClock(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3) local_unnamed_addr #1 {
  %5 = icmp eq i64 %2, 0
  br i1 %5, label %7, label %6

6:
  tail call fastcc void @fail(ptr %0, ptr @.str.15) #17
  br label %7

7:
  %8 = phi i32 [ 3, %6 ], [ 0, %4 ]
  ret i32 %8
}

define i32 @fmi3SetClock(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3) local_unnamed_addr #1 {
  %5 = icmp eq i64 %2, 0
  br i1 %5, label %7, label %6

6:
  tail call fastcc void @fail(ptr %0, ptr @.str.15) #17
  br label %7

7:
  %8 = phi i32 [ 3, %6 ], [ 0, %4 ]
  ret i32 %8
}

define i32 @fmi3GetFMUState(ptr %0, ptr %1) local_unnamed_addr #1 {
  %3 = tail call fastcc i32 @keep_state(ptr %0, ptr %1) #17
  ret i32 %3
}

define internal fastcc i32 @keep_state(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = icmp eq ptr %1, null
  br i1 %3, label %96, label %4

4:
  %5 = load ptr, ptr %1, align 8
  %6 = icmp eq ptr %5, null
  br i1 %6, label %7, label %11

7:
  %8 = tail call fastcc i64 @state_size() #17
  %9 = tail call fastcc ptr @allocate(ptr %0, i64 %8) #17
  store ptr %9, ptr %1, align 8
  %10 = icmp eq ptr %9, null
  br i1 %10, label %96, label %11

11:
  %12 = phi ptr [ %9, %7 ], [ %5, %4 ]
  store <16 x i8> zeroinitializer, ptr %12, align 1
  %13 = getelementptr inbounds i8, ptr %12, i64 16
  store <16 x i8> zeroinitializer, ptr %13, align 1
  %14 = getelementptr inbounds i8, ptr %12, i64 32
  store <8 x i8> zeroinitializer, ptr %14, align 1
  br label %15

15:
  %16 = phi i64 [ 0, %11 ], [ %65, %63 ]
  %17 = getelementptr inbounds i8, ptr @pp_token, i64 %16
  %18 = load i8, ptr %17, align 1
  %19 = icmp eq i8 %18, 0
  br i1 %19, label %20, label %45

20:
  %21 = tail call fastcc i64 @numbers_of_state() #17
  %22 = shl i64 %21, 3
  %23 = getelementptr inbounds i8, ptr %12, i64 40
  %24 = getelementptr inbounds i8, ptr %0, i64 48
  %25 = tail call ptr @memcpy(ptr %23, ptr %24, i64 64) #19
  %26 = getelementptr inbounds i8, ptr %12, i64 104
  %27 = getelementptr inbounds i8, ptr %0, i64 112
  %28 = load ptr, ptr %27, align 8
  %29 = tail call ptr @memcpy(ptr %26, ptr %28, i64 %22) #19
  %30 = getelementptr inbounds i8, ptr %26, i64 %22
  %31 = getelementptr inbounds i8, ptr %0, i64 136
  %32 = load ptr, ptr %31, align 8
  %33 = load i64, ptr @pp_numbers, align 8
  %34 = tail call ptr @memcpy(ptr %30, ptr %32, i64 %33) #19
  %35 = load ptr, ptr %31, align 8
  %36 = tail call fastcc i64 @address(ptr %35) #17
  %37 = sub nsw i64 0, %36
  tail call fastcc void @move(ptr %30, i64 %37) #17
  %38 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 16), align 8
  %39 = icmp sgt i64 %38, 0
  br i1 %39, label %40, label %114

40:
  %41 = and i64 %38, 3
  %42 = icmp ult i64 %38, 4
  br i1 %42, label %100, label %43

43:
  %44 = and i64 %38, 9223372036854775804
  br label %67

45:
  %46 = getelementptr inbounds i8, ptr %12, i64 %16
  store i8 %18, ptr %46, align 1
  %47 = or i64 %16, 1
  %48 = getelementptr inbounds i8, ptr @pp_token, i64 %47
  %49 = load i8, ptr %48, align 1
  %50 = icmp eq i8 %49, 0
  br i1 %50, label %20, label %51

51:
  %52 = getelementptr inbounds i8, ptr %12, i64 %47
  store i8 %49, ptr %52, align 1
  %53 = or i64 %16, 2
  %54 = getelementptr inbounds i8, ptr @pp_token, i64 %53
  %55 = load i8, ptr %54, align 1
  %56 = icmp eq i8 %55, 0
  br i1 %56, label %20, label %57

57:
  %58 = getelementptr inbounds i8, ptr %12, i64 %53
  store i8 %55, ptr %58, align 1
  %59 = or i64 %16, 3
  %60 = getelementptr inbounds i8, ptr @pp_token, i64 %59
  %61 = load i8, ptr %60, align 1
  %62 = icmp eq i8 %61, 0
  br i1 %62, label %20, label %63

63:
  %64 = getelementptr inbounds i8, ptr %12, i64 %59
  store i8 %61, ptr %64, align 1
  %65 = add nuw nsw i64 %16, 4
  %66 = icmp eq i64 %65, 40
  br i1 %66, label %20, label %15

67:
  %68 = phi i64 [ 0, %43 ], [ %93, %67 ]
  %69 = phi i64 [ 0, %43 ], [ %94, %67 ]
  %70 = shl nsw i64 %68, 3
  %71 = getelementptr inbounds i8, ptr @pp_code, i64 %70
  %72 = load i32, ptr %71, align 4
  %73 = zext i32 %72 to i64
  %74 = getelementptr inbounds i8, ptr %30, i64 %73
  store i64 0, ptr %74, align 8
  %75 = shl i64 %68, 3
  %76 = getelementptr inbounds i8, ptr @pp_code, i64 %75
  %77 = getelementptr inbounds i8, ptr %76, i64 8
  %78 = load i32, ptr %77, align 4
  %79 = zext i32 %78 to i64
  %80 = getelementptr inbounds i8, ptr %30, i64 %79
  store i64 0, ptr %80, align 8
  %81 = shl i64 %68, 3
  %82 = getelementptr inbounds i8, ptr @pp_code, i64 %81
  %83 = getelementptr inbounds i8, ptr %82, i64 16
  %84 = load i32, ptr %83, align 4
  %85 = zext i32 %84 to i64
  %86 = getelementptr inbounds i8, ptr %30, i64 %85
  store i64 0, ptr %86, align 8
  %87 = shl i64 %68, 3
  %88 = getelementptr inbounds i8, ptr @pp_code, i64 %87
  %89 = getelementptr inbounds i8, ptr %88, i64 24
  %90 = load i32, ptr %89, align 4
  %91 = zext i32 %90 to i64
  %92 = getelementptr inbounds i8, ptr %30, i64 %91
  store i64 0, ptr %92, align 8
  %93 = add nuw nsw i64 %68, 4
  %94 = add i64 %69, 4
  %95 = icmp eq i64 %94, %44
  br i1 %95, label %98, label %67

96:
  %97 = phi ptr [ @.str.61, %2 ], [ @.str.62, %7 ]
  tail call fastcc void @fail(ptr %0, ptr %97) #17
  br label %114

98:
  %99 = icmp eq i64 %41, 0
  br i1 %99, label %114, label %100

100:
  %101 = phi i64 [ 0, %40 ], [ %93, %98 ]
  %102 = icmp ne i64 %41, 0
  tail call void @llvm.assume(i1 %102)
  br label %103

103:
  %104 = phi i64 [ %111, %103 ], [ %101, %100 ]
  %105 = phi i64 [ %112, %103 ], [ 0, %100 ]
  %106 = shl nsw i64 %104, 3
  %107 = getelementptr inbounds i8, ptr @pp_code, i64 %106
  %108 = load i32, ptr %107, align 4
  %109 = zext i32 %108 to i64
  %110 = getelementptr inbounds i8, ptr %30, i64 %109
  store i64 0, ptr %110, align 8
  %111 = add nuw nsw i64 %104, 1
  %112 = add i64 %105, 1
  %113 = icmp eq i64 %112, %41
  br i1 %113, label %114, label %103

114:
  %115 = phi i32 [ 0, %20 ], [ 3, %96 ], [ 0, %103 ], [ 0, %98 ]
  ret i32 %115
}

define i32 @fmi3SetFMUState(ptr %0, ptr %1) local_unnamed_addr #1 {
  %3 = tail call fastcc i32 @restore(ptr %0, ptr %1) #17
  ret i32 %3
}

define internal fastcc i32 @restore(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = icmp eq ptr %1, null
  br i1 %3, label %4, label %5

4:
  tail call fastcc void @fail(ptr %0, ptr @.str.63) #17
  br label %28

5:
  %6 = tail call fastcc i32 @is_own(ptr %1) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %8, label %9

8:
  tail call fastcc void @fail(ptr %0, ptr @.str.64) #17
  br label %28

9:
  %10 = tail call fastcc i64 @numbers_of_state() #17
  %11 = shl i64 %10, 3
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  %13 = getelementptr inbounds i8, ptr %0, i64 88
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 40
  %16 = tail call ptr @memcpy(ptr %12, ptr %15, i64 64) #19
  %17 = getelementptr inbounds i8, ptr %0, i64 112
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds i8, ptr %1, i64 104
  %20 = tail call ptr @memcpy(ptr %18, ptr %19, i64 %11) #19
  %21 = getelementptr inbounds i8, ptr %19, i64 %11
  tail call fastcc void @relocate(ptr %0, ptr %21) #17
  store i64 %14, ptr %13, align 8
  %22 = icmp eq i64 %14, 0
  br i1 %22, label %23, label %28

23:
  %24 = getelementptr inbounds i8, ptr %0, i64 104
  %25 = load i64, ptr %24, align 8
  %26 = icmp eq i64 %25, 3
  br i1 %26, label %27, label %28

27:
  store i64 2, ptr %24, align 8
  br label %28

28:
  %29 = phi i32 [ 3, %4 ], [ 3, %8 ], [ 0, %27 ], [ 0, %23 ], [ 0, %9 ]
  ret i32 %29
}

define i32 @fmi3FreeFMUState(ptr %0, ptr %1) local_unnamed_addr #1 {
  tail call fastcc void @drop_state(ptr %0, ptr %1) #17
  ret i32 0
}

define internal fastcc void @drop_state(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = icmp eq ptr %1, null
  br i1 %3, label %8, label %4

4:
  %5 = load ptr, ptr %1, align 8
  %6 = icmp eq ptr %5, null
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @release(ptr %0, ptr %5) #17
  store ptr null, ptr %1, align 8
  br label %8

8:
  ret void
}

define i32 @fmi3SerializedFMUStateSize(ptr readnone %0, ptr readnone %1, ptr %2) local_unnamed_addr #3 {
  %4 = tail call fastcc i64 @state_size() #17
  store i64 %4, ptr %2, align 8
  ret i32 0
}

define internal fastcc i64 @state_size() unnamed_addr #0 {
  %1 = tail call fastcc i64 @numbers_of_state() #17
  %2 = shl i64 %1, 3
  %3 = add i64 %2, 104
  %4 = load i64, ptr @pp_numbers, align 8
  %5 = add i64 %3, %4
  ret i64 %5
}

define i32 @fmi3SerializeFMUState(ptr %0, ptr %1, ptr %2, i64 %3) local_unnamed_addr #1 {
  %5 = tail call fastcc i32 @serialise(ptr %0, ptr %1, ptr %2, i64 %3) #17
  ret i32 %5
}

define internal fastcc i32 @serialise(ptr %0, ptr %1, ptr %2, i64 %3) unnamed_addr #1 {
  %5 = icmp eq ptr %1, null
  br i1 %5, label %9, label %6

6:
  %7 = tail call fastcc i64 @state_size() #17
  %8 = icmp ult i64 %3, %7
  br i1 %8, label %9, label %10

9:
  tail call fastcc void @fail(ptr %0, ptr @.str.65) #17
  br label %12

10:
  %11 = tail call ptr @memcpy(ptr %2, ptr %1, i64 %7) #19
  br label %12

12:
  %13 = phi i32 [ 3, %9 ], [ 0, %10 ]
  ret i32 %13
}

define i32 @fmi3DeserializeFMUState(ptr %0, ptr %1, i64 %2, ptr %3) local_unnamed_addr #1 {
  %5 = tail call fastcc i32 @deserialise(ptr %0, ptr %1, i64 %2, ptr %3) #17
  ret i32 %5
}

define internal fastcc i32 @deserialise(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #1 {
  %5 = tail call fastcc i64 @state_size() #17
  %6 = icmp eq i64 %2, %5
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.66) #17
  br label %22

8:
  %9 = tail call fastcc i32 @is_own(ptr %1) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %11, label %12

11:
  tail call fastcc void @fail(ptr %0, ptr @.str.67) #17
  br label %22

12:
  %13 = load ptr, ptr %3, align 8
  %14 = icmp eq ptr %13, null
  br i1 %14, label %15, label %19

15:
  %16 = tail call fastcc ptr @allocate(ptr %0, i64 %2) #17
  store ptr %16, ptr %3, align 8
  %17 = icmp eq ptr %16, null
  br i1 %17, label %18, label %19

18:
  tail call fastcc void @fail(ptr %0, ptr @.str.62) #17
  br label %22

19:
  %20 = phi ptr [ %16, %15 ], [ %13, %12 ]
  %21 = tail call ptr @memcpy(ptr %20, ptr %1, i64 %2) #19
  br label %22

22:
  %23 = phi i32 [ 3, %7 ], [ 0, %19 ], [ 3, %18 ], [ 3, %11 ]
  ret i32 %23
}

define i32 @fmi3GetDirectionalDerivative(ptr %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, i64 %6, ptr %7, i64 %8) local_unnamed_addr #1 {
  %10 = tail call fastcc i32 @agree(ptr %0, i64 %4, i64 %6) #17
  %11 = icmp eq i32 %10, 0
  br i1 %11, label %17, label %12

12:
  %13 = tail call fastcc i32 @agree(ptr %0, i64 %2, i64 %8) #17
  %14 = icmp eq i32 %13, 0
  br i1 %14, label %17, label %15

15:
  %16 = tail call fastcc i32 @directional(ptr %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, ptr %7) #17
  br label %17

17:
  %18 = phi i32 [ %16, %15 ], [ 3, %12 ], [ 3, %9 ]
  ret i32 %18
}

define internal fastcc i32 @directional(ptr %0, ptr %1, i64 %2, ptr %3, i64 %4, ptr %5, ptr %6) unnamed_addr #1 {
  %8 = alloca ptr, align 8
  %9 = getelementptr inbounds i8, ptr %0, i64 88
  %10 = load i64, ptr %9, align 8
  %11 = icmp eq i64 %10, 0
  br i1 %11, label %16, label %12

12:
  %13 = icmp eq i64 %4, 0
  br i1 %13, label %17, label %14

14:
  %15 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  br label %25

16:
  tail call fastcc void @fail(ptr %0, ptr @.str.68) #17
  br label %254

17:
  %18 = phi double [ 1.000000e+300, %12 ], [ %49, %48 ]
  %19 = icmp eq i64 %2, 0
  br i1 %19, label %254, label %20

20:
  %21 = and i64 %2, 7
  %22 = icmp ult i64 %2, 8
  br i1 %22, label %54, label %23

23:
  %24 = and i64 %2, -8
  br label %67

25:
  %26 = phi double [ 1.000000e+300, %14 ], [ %49, %48 ]
  %27 = phi i64 [ 0, %14 ], [ %50, %48 ]
  %28 = getelementptr inbounds i32, ptr %3, i64 %27
  %29 = load i32, ptr %28, align 4
  %30 = zext i32 %29 to i64
  %31 = icmp sgt i64 %15, %30
  br i1 %31, label %32, label %35

32:
  %33 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %30
  %34 = load i64, ptr %33, align 8
  switch i64 %34, label %36 [
    i64 6, label %35
    i64 5, label %35
    i64 4, label %35
    i64 0, label %35
  ]

35:
  tail call fastcc void @fail(ptr %0, ptr @.str.69) #17
  br label %254

36:
  %37 = getelementptr inbounds double, ptr %5, i64 %27
  %38 = load double, ptr %37, align 8
  %39 = tail call fastcc i32 @finite_number(double %38) #17
  %40 = icmp eq i32 %39, 0
  br i1 %40, label %41, label %42

41:
  tail call fastcc void @fail(ptr %0, ptr @.str.70) #17
  br label %254

42:
  %43 = fcmp une double %38, 0.000000e+00
  br i1 %43, label %44, label %48

44:
  %45 = tail call fastcc double @change_of(ptr %0, i32 %29, double %38) #17
  %46 = fcmp olt double %45, %26
  br i1 %46, label %47, label %48

47:
  br label %48

48:
  %49 = phi double [ %26, %42 ], [ %26, %44 ], [ %45, %47 ]
  %50 = add nuw i64 %27, 1
  %51 = icmp eq i64 %50, %4
  br i1 %51, label %17, label %25

52:
  %53 = icmp eq i64 %21, 0
  br i1 %53, label %64, label %54

54:
  %55 = phi i64 [ 0, %20 ], [ %85, %52 ]
  %56 = icmp ne i64 %21, 0
  tail call void @llvm.assume(i1 %56)
  br label %57

57:
  %58 = phi i64 [ %61, %57 ], [ %55, %54 ]
  %59 = phi i64 [ %62, %57 ], [ 0, %54 ]
  %60 = getelementptr inbounds double, ptr %6, i64 %58
  store double 0.000000e+00, ptr %60, align 8
  %61 = add nuw i64 %58, 1
  %62 = add i64 %59, 1
  %63 = icmp eq i64 %62, %21
  br i1 %63, label %64, label %57

64:
  %65 = fcmp une double %18, 1.000000e+300
  br i1 %65, label %66, label %254

66:
  br i1 %13, label %88, label %98

67:
  %68 = phi i64 [ 0, %23 ], [ %85, %67 ]
  %69 = phi i64 [ 0, %23 ], [ %86, %67 ]
  %70 = getelementptr inbounds double, ptr %6, i64 %68
  store double 0.000000e+00, ptr %70, align 8
  %71 = getelementptr inbounds double, ptr %6, i64 %68
  %72 = getelementptr inbounds i8, ptr %71, i64 8
  store double 0.000000e+00, ptr %72, align 8
  %73 = getelementptr inbounds double, ptr %6, i64 %68
  %74 = getelementptr inbounds i8, ptr %73, i64 16
  store double 0.000000e+00, ptr %74, align 8
  %75 = getelementptr inbounds double, ptr %6, i64 %68
  %76 = getelementptr inbounds i8, ptr %75, i64 24
  store double 0.000000e+00, ptr %76, align 8
  %77 = getelementptr inbounds double, ptr %6, i64 %68
  %78 = getelementptr inbounds i8, ptr %77, i64 32
  store double 0.000000e+00, ptr %78, align 8
  %79 = getelementptr inbounds double, ptr %6, i64 %68
  %80 = getelementptr inbounds i8, ptr %79, i64 40
  store double 0.000000e+00, ptr %80, align 8
  %81 = getelementptr inbounds double, ptr %6, i64 %68
  %82 = getelementptr inbounds i8, ptr %81, i64 48
  store double 0.000000e+00, ptr %82, align 8
  %83 = getelementptr inbounds double, ptr %6, i64 %68
  %84 = getelementptr inbounds i8, ptr %83, i64 56
  store double 0.000000e+00, ptr %84, align 8
  %85 = add nuw i64 %68, 8
  %86 = add i64 %69, 8
  %87 = icmp eq i64 %86, %24
  br i1 %87, label %52, label %67

88:
  %89 = phi double [ %18, %66 ], [ %110, %98 ]
  %90 = phi double [ %18, %66 ], [ %112, %98 ]
  %91 = shl i64 %2, 3
  %92 = tail call fastcc ptr @allocate(ptr %0, i64 %91) #17
  %93 = icmp ugt i64 %4, 1
  %94 = fcmp olt double %89, %18
  %95 = select i1 %93, i1 %94, i1 false
  %96 = fcmp olt double %90, %18
  %97 = select i1 %95, i1 %96, i1 false
  br i1 %97, label %115, label %179

98:
  %99 = phi i64 [ %113, %98 ], [ 0, %66 ]
  %100 = phi double [ %112, %98 ], [ %18, %66 ]
  %101 = phi double [ %110, %98 ], [ %18, %66 ]
  %102 = getelementptr inbounds i32, ptr %3, i64 %99
  %103 = load i32, ptr %102, align 4
  %104 = getelementptr inbounds double, ptr %5, i64 %99
  %105 = load double, ptr %104, align 8
  %106 = tail call fastcc double @room_of(ptr %0, i32 %103, double %105) #17
  %107 = fneg double %105
  %108 = tail call fastcc double @room_of(ptr %0, i32 %103, double %107) #17
  %109 = fcmp olt double %106, %101
  %110 = select i1 %109, double %106, double %101
  %111 = fcmp olt double %108, %100
  %112 = select i1 %111, double %108, double %100
  %113 = add nuw i64 %99, 1
  %114 = icmp eq i64 %113, %4
  br i1 %114, label %88, label %98

115:
  %116 = icmp eq ptr %92, null
  br i1 %116, label %123, label %117

117:
  %118 = and i64 %2, 3
  %119 = icmp ult i64 %2, 4
  %120 = and i64 %2, -4
  %121 = icmp eq i64 %118, 0
  %122 = icmp ne i64 %118, 0
  br label %124

123:
  tail call fastcc void @fail(ptr %0, ptr @.str.71) #17
  br label %254

124:
  %125 = phi i64 [ %146, %145 ], [ 0, %117 ]
  %126 = getelementptr inbounds i32, ptr %3, i64 %125
  %127 = getelementptr inbounds double, ptr %5, i64 %125
  %128 = tail call fastcc i32 @directional(ptr %0, ptr %1, i64 %2, ptr %126, i64 1, ptr %127, ptr %92) #17
  %129 = icmp eq i32 %128, 0
  br i1 %129, label %130, label %177

130:
  br i1 %119, label %132, label %148

131:
  br i1 %121, label %145, label %132

132:
  %133 = phi i64 [ 0, %130 ], [ %174, %131 ]
  tail call void @llvm.assume(i1 %122)
  br label %134

134:
  %135 = phi i64 [ %142, %134 ], [ %133, %132 ]
  %136 = phi i64 [ %143, %134 ], [ 0, %132 ]
  %137 = getelementptr inbounds double, ptr %92, i64 %135
  %138 = load double, ptr %137, align 8
  %139 = getelementptr inbounds double, ptr %6, i64 %135
  %140 = load double, ptr %139, align 8
  %141 = fadd double %138, %140
  store double %141, ptr %139, align 8
  %142 = add nuw i64 %135, 1
  %143 = add i64 %136, 1
  %144 = icmp eq i64 %143, %118
  br i1 %144, label %145, label %134

145:
  %146 = add nuw i64 %125, 1
  %147 = icmp ult i64 %146, %4
  br i1 %147, label %124, label %177

148:
  %149 = phi i64 [ %174, %148 ], [ 0, %130 ]
  %150 = phi i64 [ %175, %148 ], [ 0, %130 ]
  %151 = getelementptr inbounds double, ptr %92, i64 %149
  %152 = load double, ptr %151, align 8
  %153 = getelementptr inbounds double, ptr %6, i64 %149
  %154 = load double, ptr %153, align 8
  %155 = fadd double %152, %154
  store double %155, ptr %153, align 8
  %156 = or i64 %149, 1
  %157 = getelementptr inbounds double, ptr %92, i64 %156
  %158 = load double, ptr %157, align 8
  %159 = getelementptr inbounds double, ptr %6, i64 %156
  %160 = load double, ptr %159, align 8
  %161 = fadd double %158, %160
  store double %161, ptr %159, align 8
  %162 = or i64 %149, 2
  %163 = getelementptr inbounds double, ptr %92, i64 %162
  %164 = load double, ptr %163, align 8
  %165 = getelementptr inbounds double, ptr %6, i64 %162
  %166 = load double, ptr %165, align 8
  %167 = fadd double %164, %166
  store double %167, ptr %165, align 8
  %168 = or i64 %149, 3
  %169 = getelementptr inbounds double, ptr %92, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = getelementptr inbounds double, ptr %6, i64 %168
  %172 = load double, ptr %171, align 8
  %173 = fadd double %170, %172
  store double %173, ptr %171, align 8
  %174 = add nuw i64 %149, 4
  %175 = add i64 %150, 4
  %176 = icmp eq i64 %175, %120
  br i1 %176, label %131, label %148

177:
  %178 = phi i32 [ 0, %145 ], [ %128, %124 ]
  tail call fastcc void @release(ptr %0, ptr %92) #17
  br label %254

179:
  %180 = xor i1 %96, true
  %181 = select i1 %94, i1 true, i1 %180
  %182 = select i1 %94, double 0.000000e+00, double %89
  %183 = select i1 %181, double %90, double 0.000000e+00
  store ptr null, ptr %8, align 8
  %184 = icmp eq ptr %92, null
  br i1 %184, label %250, label %185

185:
  %186 = call fastcc i32 @keep_state(ptr %0, ptr %8) #17
  %187 = icmp eq i32 %186, 0
  br i1 %187, label %188, label %222

188:
  %189 = fneg double %183
  %190 = call fastcc i32 @add(ptr %0, ptr %3, i64 %4, ptr %5, double %189) #17
  %191 = icmp eq i32 %190, 0
  br i1 %191, label %192, label %222

192:
  %193 = call fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %92) #17
  %194 = icmp eq i32 %193, 0
  br i1 %194, label %195, label %222

195:
  %196 = load ptr, ptr %8, align 8
  %197 = call fastcc i32 @restore(ptr %0, ptr %196) #17
  %198 = icmp eq i32 %197, 0
  br i1 %198, label %199, label %225

199:
  %200 = call fastcc i32 @add(ptr %0, ptr %3, i64 %4, ptr %5, double %182) #17
  %201 = icmp eq i32 %200, 0
  br i1 %201, label %202, label %222

202:
  %203 = call fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %6) #17
  %204 = icmp eq i32 %203, 0
  br i1 %204, label %205, label %222

205:
  %206 = fadd double %182, %183
  %207 = and i64 %2, 1
  %208 = icmp eq i64 %2, 1
  br i1 %208, label %213, label %209

209:
  %210 = and i64 %2, -2
  br label %229

211:
  %212 = icmp eq i64 %207, 0
  br i1 %212, label %222, label %213

213:
  %214 = phi i64 [ 0, %205 ], [ %245, %211 ]
  %215 = icmp ne i64 %207, 0
  call void @llvm.assume(i1 %215)
  %216 = getelementptr inbounds double, ptr %6, i64 %214
  %217 = load double, ptr %216, align 8
  %218 = getelementptr inbounds double, ptr %92, i64 %214
  %219 = load double, ptr %218, align 8
  %220 = fsub double %217, %219
  %221 = fdiv double %220, %206
  store double %221, ptr %216, align 8
  br label %222

222:
  %223 = phi i32 [ %200, %199 ], [ %193, %192 ], [ %190, %188 ], [ %186, %185 ], [ %203, %202 ], [ 0, %211 ], [ 0, %213 ]
  %224 = load ptr, ptr %8, align 8
  br label %225

225:
  %226 = phi ptr [ %224, %222 ], [ %196, %195 ]
  %227 = phi i32 [ %223, %222 ], [ %197, %195 ]
  %228 = icmp eq ptr %226, null
  br i1 %228, label %251, label %248

229:
  %230 = phi i64 [ 0, %209 ], [ %245, %229 ]
  %231 = phi i64 [ 0, %209 ], [ %246, %229 ]
  %232 = getelementptr inbounds double, ptr %6, i64 %230
  %233 = load double, ptr %232, align 8
  %234 = getelementptr inbounds double, ptr %92, i64 %230
  %235 = load double, ptr %234, align 8
  %236 = fsub double %233, %235
  %237 = fdiv double %236, %206
  store double %237, ptr %232, align 8
  %238 = or i64 %230, 1
  %239 = getelementptr inbounds double, ptr %6, i64 %238
  %240 = load double, ptr %239, align 8
  %241 = getelementptr inbounds double, ptr %92, i64 %238
  %242 = load double, ptr %241, align 8
  %243 = fsub double %240, %242
  %244 = fdiv double %243, %206
  store double %244, ptr %239, align 8
  %245 = add nuw i64 %230, 2
  %246 = add i64 %231, 2
  %247 = icmp eq i64 %246, %210
  br i1 %247, label %211, label %229

248:
  %249 = call fastcc i32 @restore(ptr %0, ptr %226) #17
  br label %251

250:
  tail call fastcc void @fail(ptr %0, ptr @.str.71) #17
  call fastcc void @drop_state(ptr %0, ptr %8) #17
  br label %252

251:
  call fastcc void @drop_state(ptr %0, ptr %8) #17
  call fastcc void @release(ptr %0, ptr %92) #17
  br label %252

252:
  %253 = phi i32 [ %227, %251 ], [ 3, %250 ]
  br label %254

254:
  %255 = phi i32 [ 0, %64 ], [ 3, %16 ], [ 3, %123 ], [ %253, %252 ], [ %178, %177 ], [ 3, %35 ], [ 3, %41 ], [ 0, %17 ]
  ret i32 %255
}

define i32 @fmi3DoStep(ptr %0, double %1, double %2, i1 zeroext %3, ptr %4, ptr %5, ptr %6, ptr %7) local_unnamed_addr #1 {
  %9 = tail call fastcc i32 @do_step(ptr %0, double %1, double %2) #17
  store i8 0, ptr %4, align 1
  store i8 0, ptr %5, align 1
  store i8 0, ptr %6, align 1
  %10 = tail call fastcc double @now(ptr %0) #17
  store double %10, ptr %7, align 8
  ret i32 %9
}

define internal fastcc i32 @do_step(ptr %0, double %1, double %2) unnamed_addr #1 {
  %4 = tail call fastcc double @now(ptr %0) #17
  %5 = fsub double %1, %4
  %6 = getelementptr inbounds i8, ptr %0, i64 56
  %7 = load double, ptr %6, align 8
  %8 = fmul double %7, 0x3EB0C6F7A0B5ED8D
  %9 = fcmp olt double %4, 0.000000e+00
  %10 = fneg double %4
  %11 = select i1 %9, double %10, double %4
  %12 = fmul double %11, 0x3D719799812DEA11
  %13 = fadd double %8, %12
  %14 = getelementptr inbounds i8, ptr %0, i64 88
  %15 = load i64, ptr %14, align 8
  %16 = icmp eq i64 %15, 0
  br i1 %16, label %18, label %17

17:
  tail call fastcc void @fail(ptr %0, ptr @.str.72) #17
  br label %84

18:
  %19 = getelementptr inbounds i8, ptr %0, i64 104
  %20 = load i64, ptr %19, align 8
  switch i64 %20, label %22 [
    i64 4, label %21
    i64 2, label %23
  ]

21:
  tail call fastcc void @fail(ptr %0, ptr @.str.73) #17
  br label %84

22:
  tail call fastcc void @fail(ptr %0, ptr @.str.74) #17
  br label %84

23:
  %24 = getelementptr inbounds i8, ptr %0, i64 80
  %25 = load i64, ptr %24, align 8
  %26 = icmp eq i64 %25, 0
  br i1 %26, label %28, label %27

27:
  tail call fastcc void @fail(ptr %0, ptr @.str.75) #17
  br label %84

28:
  %29 = fcmp ogt double %2, 0.000000e+00
  %30 = fcmp olt double %2, 1.000000e+300
  %31 = and i1 %29, %30
  br i1 %31, label %33, label %32

32:
  tail call fastcc void @fail(ptr %0, ptr @.str.76) #17
  br label %84

33:
  %34 = fcmp ugt double %5, %13
  %35 = fneg double %5
  %36 = fcmp ult double %13, %35
  %37 = or i1 %34, %36
  br i1 %37, label %38, label %39

38:
  tail call fastcc void @fail_with(ptr %0, ptr @.str.77, double %1, ptr @.str.78, double %4, ptr @.str.79) #17
  br label %84

39:
  %40 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 408), align 8
  %41 = fdiv double %2, %40
  %42 = fmul double %41, 0x3FEFFFFFFF768FA1
  %43 = fcmp ogt double %42, 1.000000e+15
  br i1 %43, label %44, label %45

44:
  tail call fastcc void @fail(ptr %0, ptr @.str.80) #17
  br label %84

45:
  %46 = fptosi double %42 to i64
  %47 = add nsw i64 %46, 1
  %48 = sitofp i64 %47 to double
  %49 = fdiv double %2, %48
  %50 = fsub double %49, %7
  %51 = fmul double %49, 1.000000e-09
  %52 = fcmp ogt double %50, %51
  %53 = fneg double %50
  %54 = fcmp olt double %51, %53
  %55 = or i1 %52, %54
  br i1 %55, label %57, label %56

56:
  tail call fastcc void @lead(ptr %0, double %2) #17
  br label %60

57:
  %58 = tail call fastcc i64 @change_step(ptr %0, double %49) #17
  tail call fastcc void @lead(ptr %0, double %2) #17
  %59 = icmp eq i64 %58, 1
  br i1 %59, label %60, label %76

60:
  %61 = getelementptr inbounds i8, ptr %0, i64 72
  %62 = load i64, ptr %61, align 8
  %63 = icmp eq i64 %62, 2
  br i1 %63, label %64, label %66

64:
  %65 = tail call fastcc i64 @restart(ptr %0) #17
  br label %66

66:
  %67 = phi i64 [ %65, %64 ], [ 1, %60 ]
  %68 = icmp eq i64 %67, 1
  %69 = icmp sgt i64 %46, 0
  %70 = and i1 %69, %68
  br i1 %70, label %71, label %73

71:
  %72 = tail call fastcc i64 @advance(ptr %0, i64 %46, i64 0) #17
  br label %73

73:
  %74 = phi i64 [ %72, %71 ], [ %67, %66 ]
  %75 = icmp eq i64 %74, 1
  br i1 %75, label %79, label %76

76:
  %77 = phi i64 [ %74, %73 ], [ %58, %57 ]
  %78 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 0, ptr %78, align 8
  br label %82

79:
  %80 = tail call fastcc i64 @advance(ptr %0, i64 1, i64 1) #17
  store i64 0, ptr %61, align 8
  %81 = icmp eq i64 %80, 1
  br i1 %81, label %84, label %82

82:
  %83 = phi i64 [ %77, %76 ], [ %80, %79 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.81, i64 %83, ptr @.str.82) #17
  br label %84

84:
  %85 = phi i32 [ 3, %17 ], [ 3, %21 ], [ 3, %22 ], [ 3, %27 ], [ 3, %32 ], [ 3, %38 ], [ 3, %44 ], [ 3, %82 ], [ 0, %79 ]
  ret i32 %85
}

define internal fastcc double @now(ptr %0) unnamed_addr #4 {
  %2 = getelementptr inbounds i8, ptr %0, i64 48
  %3 = load double, ptr %2, align 8
  %4 = getelementptr inbounds i8, ptr %0, i64 64
  %5 = load i64, ptr %4, align 8
  %6 = sitofp i64 %5 to double
  %7 = getelementptr inbounds i8, ptr %0, i64 56
  %8 = load double, ptr %7, align 8
  %9 = fmul double %8, %6
  %10 = fadd double %3, %9
  ret double %10
}

define i32 @fmi3EnterEventMode(ptr %0) local_unnamed_addr #1 {
  %2 = tail call fastcc i32 @enter_events(ptr %0) #17
  ret i32 %2
}

define internal fastcc i32 @enter_events(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i32 @is_called_in(ptr %0, i32 2, i32 3, ptr @.str.83) #17
  %3 = icmp eq i32 %2, 0
  br i1 %3, label %6, label %4

4:
  %5 = getelementptr inbounds i8, ptr %0, i64 104
  store i64 2, ptr %5, align 8
  br label %6

6:
  %7 = phi i32 [ 0, %4 ], [ 3, %1 ]
  ret i32 %7
}

define i32 @fmi3UpdateDiscreteStates(ptr %0, ptr %1, ptr %2, ptr %3, ptr %4, ptr %5, ptr %6) local_unnamed_addr #1 {
  store i8 0, ptr %5, align 1
  store i8 0, ptr %4, align 1
  store i8 0, ptr %3, align 1
  store i8 0, ptr %2, align 1
  store i8 0, ptr %1, align 1
  store double 0.000000e+00, ptr %6, align 8
  %8 = tail call fastcc i32 @update_events(ptr %0) #17
  ret i32 %8
}

define internal fastcc i32 @update_events(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i32 @is_called_in(ptr %0, i32 2, i32 2, ptr @.str.85) #17
  %3 = icmp eq i32 %2, 0
  %4 = select i1 %3, i32 3, i32 0
  ret i32 %4
}

define i32 @fmi3EnterContinuousTimeMode(ptr %0) local_unnamed_addr #1 {
  %2 = tail call fastcc i32 @enter_continuous(ptr %0) #17
  ret i32 %2
}

define internal fastcc i32 @enter_continuous(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i32 @is_called_in(ptr %0, i32 2, i32 2, ptr @.str.86) #17
  %3 = icmp eq i32 %2, 0
  br i1 %3, label %6, label %4

4:
  %5 = getelementptr inbounds i8, ptr %0, i64 104
  store i64 3, ptr %5, align 8
  br label %6

6:
  %7 = phi i32 [ 0, %4 ], [ 3, %1 ]
  ret i32 %7
}

define i32 @fmi3CompletedIntegratorStep(ptr %0, i1 zeroext %1, ptr %2, ptr %3) local_unnamed_addr #1 {
  store i8 0, ptr %2, align 1
  store i8 0, ptr %3, align 1
  %5 = tail call fastcc i32 @complete_step(ptr %0) #17
  ret i32 %5
}

define internal fastcc i32 @complete_step(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i32 @is_called_in(ptr %0, i32 3, i32 3, ptr @.str.87) #17
  %3 = icmp eq i32 %2, 0
  %4 = select i1 %3, i32 3, i32 0
  ret i32 %4
}

define i32 @fmi3SetTime(ptr %0, double %1) local_unnamed_addr #1 {
  %3 = tail call fastcc i32 @set_time(ptr %0, double %1) #17
  ret i32 %3
}

define internal fastcc i32 @set_time(ptr %0, double %1) unnamed_addr #1 {
  %3 = tail call fastcc i32 @is_called_in(ptr %0, i32 2, i32 3, ptr @.str.88) #17
  %4 = icmp eq i32 %3, 0
  br i1 %4, label %17, label %5

5:
  %6 = tail call fastcc i32 @finite_number(double %1) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %8, label %9

8:
  tail call fastcc void @fail(ptr %0, ptr @.str.89) #17
  br label %17

9:
  %10 = tail call fastcc double @now(ptr %0) #17
  %11 = fcmp une double %1, %10
  br i1 %11, label %12, label %14

12:
  %13 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %13, align 8
  br label %14

14:
  %15 = getelementptr inbounds i8, ptr %0, i64 48
  store double %1, ptr %15, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %16, align 8
  br label %17

17:
  %18 = phi i32 [ 0, %14 ], [ 3, %8 ], [ 3, %2 ]
  ret i32 %18
}

define i32 @fmi3SetContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @set_states(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @set_states(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %5 = tail call fastcc i32 @is_called_in(ptr %0, i32 3, i32 3, ptr @.str.90) #17
  %6 = icmp eq i32 %5, 0
  br i1 %6, label %25, label %7

7:
  %8 = shl nsw i64 %4, 1
  %9 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %8) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %25, label %11

11:
  %12 = tail call fastcc i32 @all_finite(ptr %1, i64 %8) #17
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %15

14:
  tail call fastcc void @fail(ptr %0, ptr @.str.91) #17
  br label %25

15:
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %17 = tail call fastcc ptr @reals(ptr %0, i64 %16) #17
  %18 = shl i64 %4, 3
  %19 = tail call ptr @memcpy(ptr %17, ptr %1, i64 %18) #19
  %20 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %21 = tail call fastcc ptr @reals(ptr %0, i64 %20) #17
  %22 = getelementptr inbounds double, ptr %1, i64 %4
  %23 = tail call ptr @memcpy(ptr %21, ptr %22, i64 %18) #19
  %24 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %24, align 8
  br label %25

25:
  %26 = phi i32 [ 0, %15 ], [ 3, %14 ], [ 3, %3 ], [ 3, %7 ]
  ret i32 %26
}

define i32 @fmi3GetContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_states(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_states(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %5 = tail call fastcc i32 @is_called_in(ptr %0, i32 1, i32 4, ptr @early) #17
  %6 = icmp eq i32 %5, 0
  br i1 %6, label %20, label %7

7:
  %8 = shl nsw i64 %4, 1
  %9 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %8) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %20, label %11

11:
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %13 = tail call fastcc ptr @reals(ptr %0, i64 %12) #17
  %14 = shl i64 %4, 3
  %15 = tail call ptr @memcpy(ptr %1, ptr %13, i64 %14) #19
  %16 = getelementptr inbounds double, ptr %1, i64 %4
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %18 = tail call fastcc ptr @reals(ptr %0, i64 %17) #17
  %19 = tail call ptr @memcpy(ptr %16, ptr %18, i64 %14) #19
  br label %20

20:
  %21 = phi i32 [ 0, %11 ], [ 3, %3 ], [ 3, %7 ]
  ret i32 %21
}

define i32 @fmi3GetContinuousStateDerivatives(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_slopes(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_slopes(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %5 = tail call fastcc i32 @is_called_in(ptr %0, i32 1, i32 4, ptr @early) #17
  %6 = icmp eq i32 %5, 0
  br i1 %6, label %24, label %7

7:
  %8 = shl nsw i64 %4, 1
  %9 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %8) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %24, label %11

11:
  %12 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 0, ptr %12, align 8
  %13 = tail call fastcc i32 @accelerate(ptr %0) #17
  %14 = icmp eq i32 %13, 0
  br i1 %14, label %15, label %24

15:
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %17 = tail call fastcc ptr @reals(ptr %0, i64 %16) #17
  %18 = shl i64 %4, 3
  %19 = tail call ptr @memcpy(ptr %1, ptr %17, i64 %18) #19
  %20 = getelementptr inbounds double, ptr %1, i64 %4
  %21 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  %22 = tail call fastcc ptr @reals(ptr %0, i64 %21) #17
  %23 = tail call ptr @memcpy(ptr %20, ptr %22, i64 %18) #19
  br label %24

24:
  %25 = phi i32 [ 3, %7 ], [ 3, %3 ], [ 0, %15 ], [ 2, %11 ]
  ret i32 %25
}

define i32 @fmi3GetEventIndicators(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_indicators(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_indicators(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = tail call fastcc i32 @is_called_in(ptr %0, i32 1, i32 4, ptr @early) #17
  %5 = icmp eq i32 %4, 0
  br i1 %5, label %31, label %6

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 32), align 8
  %8 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %7) #17
  %9 = icmp eq i32 %8, 0
  br i1 %9, label %31, label %10

10:
  %11 = icmp eq i64 %2, 0
  br i1 %11, label %31, label %12

12:
  %13 = getelementptr inbounds i8, ptr %0, i64 136
  %14 = load ptr, ptr %13, align 8
  %15 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 248), align 8
  %16 = getelementptr inbounds i8, ptr %14, i64 %15
  %17 = tail call fastcc i64 @address(ptr %16) #17
  %18 = tail call fastcc i64 @request(ptr %0, i64 3, i64 %17) #17
  %19 = icmp eq i64 %18, 1
  br i1 %19, label %20, label %31

20:
  %21 = phi i64 [ %29, %20 ], [ 0, %12 ]
  %22 = tail call fastcc ptr @reals(ptr %0, i64 %15) #17
  %23 = getelementptr inbounds i32, ptr @pp_indicators, i64 %21
  %24 = load i32, ptr %23, align 4
  %25 = zext i32 %24 to i64
  %26 = getelementptr inbounds double, ptr %22, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %1, i64 %21
  store double %27, ptr %28, align 8
  %29 = add nuw i64 %21, 1
  %30 = icmp eq i64 %29, %2
  br i1 %30, label %31, label %20

31:
  %32 = phi i32 [ 0, %10 ], [ 3, %6 ], [ 3, %3 ], [ 2, %12 ], [ 0, %20 ]
  ret i32 %32
}

define i32 @fmi3GetNominalsOfContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_nominals(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_nominals(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %5 = shl nsw i64 %4, 1
  %6 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %5) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %48, label %8

8:
  %9 = icmp eq i64 %2, 0
  br i1 %9, label %48, label %10

10:
  %11 = and i64 %2, 7
  %12 = icmp ult i64 %2, 8
  br i1 %12, label %38, label %13

13:
  %14 = and i64 %2, -8
  br label %15

15:
  %16 = phi i64 [ 0, %13 ], [ %33, %15 ]
  %17 = phi i64 [ 0, %13 ], [ %34, %15 ]
  %18 = getelementptr inbounds double, ptr %1, i64 %16
  store double 1.000000e+00, ptr %18, align 8
  %19 = getelementptr inbounds double, ptr %1, i64 %16
  %20 = getelementptr inbounds i8, ptr %19, i64 8
  store double 1.000000e+00, ptr %20, align 8
  %21 = getelementptr inbounds double, ptr %1, i64 %16
  %22 = getelementptr inbounds i8, ptr %21, i64 16
  store double 1.000000e+00, ptr %22, align 8
  %23 = getelementptr inbounds double, ptr %1, i64 %16
  %24 = getelementptr inbounds i8, ptr %23, i64 24
  store double 1.000000e+00, ptr %24, align 8
  %25 = getelementptr inbounds double, ptr %1, i64 %16
  %26 = getelementptr inbounds i8, ptr %25, i64 32
  store double 1.000000e+00, ptr %26, align 8
  %27 = getelementptr inbounds double, ptr %1, i64 %16
  %28 = getelementptr inbounds i8, ptr %27, i64 40
  store double 1.000000e+00, ptr %28, align 8
  %29 = getelementptr inbounds double, ptr %1, i64 %16
  %30 = getelementptr inbounds i8, ptr %29, i64 48
  store double 1.000000e+00, ptr %30, align 8
  %31 = getelementptr inbounds double, ptr %1, i64 %16
  %32 = getelementptr inbounds i8, ptr %31, i64 56
  store double 1.000000e+00, ptr %32, align 8
  %33 = add nuw i64 %16, 8
  %34 = add i64 %17, 8
  %35 = icmp eq i64 %34, %14
  br i1 %35, label %36, label %15

36:
  %37 = icmp eq i64 %11, 0
  br i1 %37, label %48, label %38

38:
  %39 = phi i64 [ 0, %10 ], [ %33, %36 ]
  %40 = icmp ne i64 %11, 0
  tail call void @llvm.assume(i1 %40)
  br label %41

41:
  %42 = phi i64 [ %45, %41 ], [ %39, %38 ]
  %43 = phi i64 [ %46, %41 ], [ 0, %38 ]
  %44 = getelementptr inbounds double, ptr %1, i64 %42
  store double 1.000000e+00, ptr %44, align 8
  %45 = add nuw i64 %42, 1
  %46 = add i64 %43, 1
  %47 = icmp eq i64 %46, %11
  br i1 %47, label %48, label %41

48:
  %49 = phi i32 [ 3, %3 ], [ 0, %8 ], [ 0, %41 ], [ 0, %36 ]
  ret i32 %49
}

define i32 @fmi3GetNumberOfEventIndicators(ptr readnone %0, ptr %1) local_unnamed_addr #3 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 32), align 8
  store i64 %3, ptr %1, align 8
  ret i32 0
}

define i32 @fmi3GetNumberOfContinuousStates(ptr readnone %0, ptr %1) local_unnamed_addr #3 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %4 = shl i64 %3, 1
  store i64 %4, ptr %1, align 8
  ret i32 0
}

define i32 @fmi3EnterStepMode(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.16) #17
  ret i32 3
}

define i32 @fmi3EnterConfigurationMode(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.17) #17
  ret i32 3
}

define i32 @fmi3ExitConfigurationMode(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.18) #17
  ret i32 3
}

define i32 @fmi3EvaluateDiscreteStates(ptr %0) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.19) #17
  ret i32 3
}

define i32 @fmi3GetNumberOfVariableDependencies(ptr %0, i32 %1, ptr readnone %2) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.20) #17
  ret i32 3
}

define i32 @fmi3GetVariableDependencies(ptr %0, i32 %1, ptr readnone %2, ptr readnone %3, ptr readnone %4, ptr readnone %5, i64 %6) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.21) #17
  ret i32 3
}

define i32 @fmi3GetAdjointDerivative(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, i64 %4, ptr readnone %5, i64 %6, ptr readnone %7, i64 %8) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.22) #17
  ret i32 3
}

define i32 @fmi3GetIntervalDecimal(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.23) #17
  ret i32 3
}

define i32 @fmi3GetIntervalFraction(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4, ptr readnone %5) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.24) #17
  ret i32 3
}

define i32 @fmi3GetShiftDecimal(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.25) #17
  ret i32 3
}

define i32 @fmi3GetShiftFraction(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.26) #17
  ret i32 3
}

define i32 @fmi3SetIntervalDecimal(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.27) #17
  ret i32 3
}

define i32 @fmi3SetIntervalFraction(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.28) #17
  ret i32 3
}

define i32 @fmi3SetShiftDecimal(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.29) #17
  ret i32 3
}

define i32 @fmi3SetShiftFraction(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.30) #17
  ret i32 3
}

define i32 @fmi3GetOutputDerivatives(ptr %0, ptr readnone %1, i64 %2, ptr readnone %3, ptr readnone %4, i64 %5) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.31) #17
  ret i32 3
}

define i32 @fmi3ActivateModelPartition(ptr %0, i32 %1, double %2) local_unnamed_addr #1 {
  tail call fastcc void @fail(ptr %0, ptr @.str.32) #17
  ret i32 3
}

define internal fastcc ptr @create(ptr %0, ptr %1, ptr %2, i32 %3) unnamed_addr #1 {
  %5 = alloca %struct.Instance, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 dereferenceable(40) %5, ptr align 8 dereferenceable(40) %2, i64 40, i1 false)
  %6 = getelementptr inbounds i8, ptr %5, i64 40
  store ptr %0, ptr %6, align 8
  %7 = icmp eq ptr %1, null
  br i1 %7, label %21, label %8

8:
  %9 = tail call fastcc i32 @same(ptr %1) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %21, label %11

11:
  %12 = tail call i32 @pp_processor() #19
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %21, label %14

14:
  %15 = icmp ne i32 %3, 0
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 384), align 8
  %17 = icmp eq i64 %16, 0
  %18 = select i1 %15, i1 %17, i1 false
  br i1 %18, label %21, label %19

19:
  %20 = icmp eq ptr %0, null
  br i1 %20, label %29, label %23

21:
  %22 = phi ptr [ @.str.33, %4 ], [ @.str.34, %11 ], [ @.str.33, %8 ], [ @.str.35, %14 ]
  call fastcc void @say(ptr %5, i32 3, ptr %22) #17
  br label %100

23:
  %24 = phi i64 [ %28, %23 ], [ 0, %19 ]
  %25 = getelementptr inbounds i8, ptr %0, i64 %24
  %26 = load i8, ptr %25, align 1
  %27 = icmp eq i8 %26, 0
  %28 = add i64 %24, 1
  br i1 %27, label %29, label %23

29:
  %30 = phi i64 [ 0, %19 ], [ %24, %23 ]
  %31 = tail call fastcc i64 @numbers_of_state() #17
  %32 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  %33 = add nsw i64 %32, %31
  %34 = shl i64 %33, 3
  %35 = load i64, ptr @pp_numbers, align 8
  %36 = add i64 %30, 649
  %37 = add i64 %36, %35
  %38 = add i64 %37, %34
  %39 = tail call fastcc ptr @allocate(ptr %2, i64 %38) #17
  %40 = icmp eq ptr %39, null
  br i1 %40, label %41, label %42

41:
  call fastcc void @say(ptr %5, i32 3, ptr @.str.36) #17
  br label %100

42:
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 dereferenceable(40) %39, ptr align 8 dereferenceable(40) %2, i64 40, i1 false)
  %43 = getelementptr inbounds i8, ptr %39, i64 640
  %44 = getelementptr inbounds i8, ptr %39, i64 136
  store ptr %43, ptr %44, align 8
  %45 = getelementptr inbounds i8, ptr %43, i64 %35
  %46 = getelementptr inbounds i8, ptr %39, i64 112
  store ptr %45, ptr %46, align 8
  %47 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %48 = getelementptr inbounds double, ptr %45, i64 %47
  %49 = getelementptr inbounds i8, ptr %39, i64 120
  store ptr %48, ptr %49, align 8
  %50 = getelementptr inbounds double, ptr %48, i64 %32
  %51 = getelementptr inbounds i8, ptr %39, i64 128
  store ptr %50, ptr %51, align 8
  %52 = getelementptr inbounds double, ptr %50, i64 %32
  %53 = getelementptr inbounds i8, ptr %52, i64 8
  %54 = icmp eq i64 %30, 0
  br i1 %54, label %74, label %55

55:
  %56 = and i64 %30, 3
  %57 = icmp ult i64 %30, 4
  br i1 %57, label %62, label %58

58:
  %59 = and i64 %30, -4
  br label %79

60:
  %61 = icmp eq i64 %56, 0
  br i1 %61, label %74, label %62

62:
  %63 = phi i64 [ 0, %55 ], [ %97, %60 ]
  %64 = icmp ne i64 %56, 0
  tail call void @llvm.assume(i1 %64)
  br label %65

65:
  %66 = phi i64 [ %71, %65 ], [ %63, %62 ]
  %67 = phi i64 [ %72, %65 ], [ 0, %62 ]
  %68 = getelementptr inbounds i8, ptr %0, i64 %66
  %69 = load i8, ptr %68, align 1
  %70 = getelementptr inbounds i8, ptr %53, i64 %66
  store i8 %69, ptr %70, align 1
  %71 = add nuw i64 %66, 1
  %72 = add i64 %67, 1
  %73 = icmp eq i64 %72, %56
  br i1 %73, label %74, label %65

74:
  %75 = getelementptr inbounds i8, ptr %53, i64 %30
  store i8 0, ptr %75, align 1
  %76 = getelementptr inbounds i8, ptr %39, i64 40
  store ptr %53, ptr %76, align 8
  %77 = zext i32 %3 to i64
  %78 = getelementptr inbounds i8, ptr %39, i64 88
  store i64 %77, ptr %78, align 8
  tail call fastcc void @begin(ptr %39) #17
  br label %100

79:
  %80 = phi i64 [ 0, %58 ], [ %97, %79 ]
  %81 = phi i64 [ 0, %58 ], [ %98, %79 ]
  %82 = getelementptr inbounds i8, ptr %0, i64 %80
  %83 = load i8, ptr %82, align 1
  %84 = getelementptr inbounds i8, ptr %53, i64 %80
  store i8 %83, ptr %84, align 1
  %85 = or i64 %80, 1
  %86 = getelementptr inbounds i8, ptr %0, i64 %85
  %87 = load i8, ptr %86, align 1
  %88 = getelementptr inbounds i8, ptr %53, i64 %85
  store i8 %87, ptr %88, align 1
  %89 = or i64 %80, 2
  %90 = getelementptr inbounds i8, ptr %0, i64 %89
  %91 = load i8, ptr %90, align 1
  %92 = getelementptr inbounds i8, ptr %53, i64 %89
  store i8 %91, ptr %92, align 1
  %93 = or i64 %80, 3
  %94 = getelementptr inbounds i8, ptr %0, i64 %93
  %95 = load i8, ptr %94, align 1
  %96 = getelementptr inbounds i8, ptr %53, i64 %93
  store i8 %95, ptr %96, align 1
  %97 = add nuw i64 %80, 4
  %98 = add i64 %81, 4
  %99 = icmp eq i64 %98, %59
  br i1 %99, label %60, label %79

100:
  %101 = phi ptr [ null, %21 ], [ %39, %74 ], [ null, %41 ]
  ret ptr %101
}

declare void @llvm.memcpy.p0.p0.i64(ptr noalias, ptr noalias, i64, i1 immarg) #5

define internal fastcc i32 @same(ptr %0) unnamed_addr #6 {
  %2 = load i8, ptr %0, align 1
  %3 = icmp eq i8 %2, 0
  br i1 %3, label %15, label %4

4:
  %5 = phi i8 [ %13, %10 ], [ %2, %1 ]
  %6 = phi ptr [ %12, %10 ], [ @pp_token, %1 ]
  %7 = phi ptr [ %11, %10 ], [ %0, %1 ]
  %8 = load i8, ptr %6, align 1
  %9 = icmp eq i8 %5, %8
  br i1 %9, label %10, label %15

10:
  %11 = getelementptr inbounds i8, ptr %7, i64 1
  %12 = getelementptr inbounds i8, ptr %6, i64 1
  %13 = load i8, ptr %11, align 1
  %14 = icmp eq i8 %13, 0
  br i1 %14, label %15, label %4

15:
  %16 = phi ptr [ @pp_token, %1 ], [ %12, %10 ], [ %6, %4 ]
  %17 = phi i8 [ 0, %1 ], [ 0, %10 ], [ %5, %4 ]
  %18 = load i8, ptr %16, align 1
  %19 = icmp eq i8 %17, %18
  %20 = zext i1 %19 to i32
  ret i32 %20
}

declare i32 @pp_processor() local_unnamed_addr #7

define internal fastcc void @say(ptr %0, i32 %1, ptr %2) unnamed_addr #1 {
  %4 = load ptr, ptr %0, align 8
  %5 = icmp eq ptr %4, null
  br i1 %5, label %11, label %6

6:
  %7 = icmp eq i32 %1, 1
  %8 = select i1 %7, ptr @.str.37, ptr @.str.1
  %9 = getelementptr inbounds i8, ptr %0, i64 32
  %10 = load ptr, ptr %9, align 8
  tail call void %4(ptr %10, i32 %1, ptr %8, ptr %2) #19
  br label %11

11:
  ret void
}

define internal fastcc i64 @numbers_of_state() unnamed_addr #0 {
  %1 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  %3 = add nsw i64 %2, %1
  ret i64 %3
}

define internal fastcc ptr @allocate(ptr %0, i64 %1) unnamed_addr #1 {
  %3 = getelementptr inbounds i8, ptr %0, i64 8
  %4 = load ptr, ptr %3, align 8
  %5 = icmp eq ptr %4, null
  br i1 %5, label %8, label %6

6:
  %7 = tail call ptr %4(i64 %1, i64 1) #19
  br label %10

8:
  %9 = tail call ptr @calloc(i64 %1, i64 1) #19
  br label %10

10:
  %11 = phi ptr [ %7, %6 ], [ %9, %8 ]
  ret ptr %11
}

declare ptr @calloc(i64, i64) local_unnamed_addr #7

define internal fastcc void @release(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = getelementptr inbounds i8, ptr %0, i64 16
  %4 = load ptr, ptr %3, align 8
  %5 = icmp eq ptr %4, null
  br i1 %5, label %7, label %6

6:
  tail call void %4(ptr %1) #19
  br label %8

7:
  tail call void @free(ptr %1) #19
  br label %8

8:
  ret void
}

declare void @free(ptr) local_unnamed_addr #7

define internal fastcc i32 @finite_number(double %0) unnamed_addr #0 {
  %2 = tail call double @llvm.fabs.f64(double %0)
  %3 = fcmp olt double %2, 1.000000e+100
  %4 = zext i1 %3 to i32
  ret i32 %4
}

define internal fastcc ptr @drive_of(ptr %0, i64 %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 136
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %1
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Place, ptr @pp_places, i64 %7
  %9 = load i64, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %4, i64 %9
  ret ptr %10
}

define internal fastcc void @turn_on(ptr %0, ptr %1, double %2, double %3, double %4) unnamed_addr #8 {
  %6 = getelementptr inbounds i8, ptr %1, i64 48
  store i64 3, ptr %6, align 8
  %7 = getelementptr inbounds i8, ptr %1, i64 96
  store double %2, ptr %7, align 8
  %8 = tail call fastcc double @now(ptr %0) #17
  %9 = getelementptr inbounds i8, ptr %1, i64 112
  store double %8, ptr %9, align 8
  %10 = getelementptr inbounds i8, ptr %1, i64 104
  store double %3, ptr %10, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 120
  store double %4, ptr %11, align 8
  ret void
}

define internal fastcc i32 @balance(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 72), align 8
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %6 = tail call fastcc ptr @reals(ptr %0, i64 %5) #17
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 152), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = add nsw i64 %4, %3
  %12 = shl nsw i64 %11, 3
  %13 = tail call fastcc ptr @allocate(ptr %0, i64 %12) #17
  %14 = getelementptr inbounds double, ptr %13, i64 %3
  %15 = icmp eq ptr %13, null
  br i1 %15, label %359, label %16

16:
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 64), align 8
  %18 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free_balancing, i64 %17) #17
  %19 = icmp ne i32 %18, 0
  %20 = icmp sgt i64 %3, 0
  %21 = and i1 %19, %20
  br i1 %21, label %22, label %41

22:
  %23 = and i64 %3, 3
  %24 = icmp ult i64 %3, 4
  br i1 %24, label %29, label %25

25:
  %26 = and i64 %3, 9223372036854775804
  br label %65

27:
  %28 = icmp eq i64 %23, 0
  br i1 %28, label %41, label %29

29:
  %30 = phi i64 [ 0, %22 ], [ %83, %27 ]
  %31 = icmp ne i64 %23, 0
  tail call void @llvm.assume(i1 %31)
  br label %32

32:
  %33 = phi i64 [ %38, %32 ], [ %30, %29 ]
  %34 = phi i64 [ %39, %32 ], [ 0, %29 ]
  %35 = getelementptr inbounds double, ptr %6, i64 %33
  %36 = load double, ptr %35, align 8
  %37 = getelementptr inbounds double, ptr %13, i64 %33
  store double %36, ptr %37, align 8
  %38 = add nuw nsw i64 %33, 1
  %39 = add i64 %34, 1
  %40 = icmp eq i64 %39, %23
  br i1 %40, label %41, label %32

41:
  %42 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 80), align 8
  %43 = icmp sgt i64 %42, 0
  %44 = select i1 %19, i1 %43, i1 false
  br i1 %44, label %45, label %86

45:
  %46 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 88), align 8
  %47 = icmp sgt i64 %46, 0
  %48 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 64), align 8
  %49 = icmp sgt i64 %4, 0
  %50 = and i64 %3, 3
  %51 = icmp ult i64 %3, 4
  %52 = and i64 %3, 9223372036854775804
  %53 = icmp eq i64 %50, 0
  %54 = icmp ne i64 %50, 0
  %55 = and i64 %46, 1
  %56 = icmp eq i64 %46, 1
  %57 = and i64 %46, 9223372036854775806
  %58 = icmp eq i64 %55, 0
  %59 = icmp ne i64 %55, 0
  %60 = and i64 %4, 1
  %61 = icmp eq i64 %4, 1
  %62 = and i64 %4, 9223372036854775806
  %63 = icmp eq i64 %60, 0
  %64 = icmp ne i64 %60, 0
  br label %93

65:
  %66 = phi i64 [ 0, %25 ], [ %83, %65 ]
  %67 = phi i64 [ 0, %25 ], [ %84, %65 ]
  %68 = getelementptr inbounds double, ptr %6, i64 %66
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds double, ptr %13, i64 %66
  store double %69, ptr %70, align 8
  %71 = or i64 %66, 1
  %72 = getelementptr inbounds double, ptr %6, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %13, i64 %71
  store double %73, ptr %74, align 8
  %75 = or i64 %66, 2
  %76 = getelementptr inbounds double, ptr %6, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = getelementptr inbounds double, ptr %13, i64 %75
  store double %77, ptr %78, align 8
  %79 = or i64 %66, 3
  %80 = getelementptr inbounds double, ptr %6, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = getelementptr inbounds double, ptr %13, i64 %79
  store double %81, ptr %82, align 8
  %83 = add nuw nsw i64 %66, 4
  %84 = add i64 %67, 4
  %85 = icmp eq i64 %84, %26
  br i1 %85, label %27, label %65

86:
  %87 = phi double [ 0.000000e+00, %41 ], [ %228, %227 ]
  br i1 %21, label %88, label %245

88:
  %89 = and i64 %3, 3
  %90 = icmp ult i64 %3, 4
  br i1 %90, label %233, label %91

91:
  %92 = and i64 %3, 9223372036854775804
  br label %248

93:
  %94 = phi double [ 0.000000e+00, %45 ], [ %228, %227 ]
  %95 = phi i64 [ 0, %45 ], [ %229, %227 ]
  %96 = shl nuw nsw i64 %95, 4
  %97 = getelementptr inbounds i8, ptr @pp_instants, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = getelementptr inbounds i8, ptr %97, i64 8
  %100 = load double, ptr %99, align 8
  %101 = fcmp ogt double %100, 0.000000e+00
  br i1 %101, label %102, label %227

102:
  br i1 %20, label %103, label %116

103:
  br i1 %51, label %105, label %118

104:
  br i1 %53, label %116, label %105

105:
  %106 = phi i64 [ 0, %103 ], [ %136, %104 ]
  tail call void @llvm.assume(i1 %54)
  br label %107

107:
  %108 = phi i64 [ %113, %107 ], [ %106, %105 ]
  %109 = phi i64 [ %114, %107 ], [ 0, %105 ]
  %110 = getelementptr inbounds double, ptr %13, i64 %108
  %111 = load double, ptr %110, align 8
  %112 = getelementptr inbounds double, ptr %6, i64 %108
  store double %111, ptr %112, align 8
  %113 = add nuw nsw i64 %108, 1
  %114 = add i64 %109, 1
  %115 = icmp eq i64 %114, %50
  br i1 %115, label %116, label %107

116:
  br i1 %47, label %117, label %151

117:
  br i1 %56, label %140, label %153

118:
  %119 = phi i64 [ %136, %118 ], [ 0, %103 ]
  %120 = phi i64 [ %137, %118 ], [ 0, %103 ]
  %121 = getelementptr inbounds double, ptr %13, i64 %119
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %6, i64 %119
  store double %122, ptr %123, align 8
  %124 = or i64 %119, 1
  %125 = getelementptr inbounds double, ptr %13, i64 %124
  %126 = load double, ptr %125, align 8
  %127 = getelementptr inbounds double, ptr %6, i64 %124
  store double %126, ptr %127, align 8
  %128 = or i64 %119, 2
  %129 = getelementptr inbounds double, ptr %13, i64 %128
  %130 = load double, ptr %129, align 8
  %131 = getelementptr inbounds double, ptr %6, i64 %128
  store double %130, ptr %131, align 8
  %132 = or i64 %119, 3
  %133 = getelementptr inbounds double, ptr %13, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %6, i64 %132
  store double %134, ptr %135, align 8
  %136 = add nuw nsw i64 %119, 4
  %137 = add i64 %120, 4
  %138 = icmp eq i64 %137, %52
  br i1 %138, label %104, label %118

139:
  br i1 %58, label %151, label %140

140:
  %141 = phi i64 [ 0, %117 ], [ %175, %139 ]
  tail call void @llvm.assume(i1 %59)
  %142 = getelementptr inbounds i32, ptr @pp_spins, i64 %141
  %143 = load i32, ptr %142, align 4
  %144 = zext i32 %143 to i64
  %145 = getelementptr inbounds double, ptr %8, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = fmul double %98, %146
  %148 = getelementptr inbounds double, ptr %6, i64 %144
  %149 = load double, ptr %148, align 8
  %150 = fadd double %149, %147
  store double %150, ptr %148, align 8
  br label %151

151:
  %152 = fcmp une double %98, 0.000000e+00
  br i1 %152, label %178, label %184

153:
  %154 = phi i64 [ %175, %153 ], [ 0, %117 ]
  %155 = phi i64 [ %176, %153 ], [ 0, %117 ]
  %156 = getelementptr inbounds i32, ptr @pp_spins, i64 %154
  %157 = load i32, ptr %156, align 4
  %158 = zext i32 %157 to i64
  %159 = getelementptr inbounds double, ptr %8, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fmul double %98, %160
  %162 = getelementptr inbounds double, ptr %6, i64 %158
  %163 = load double, ptr %162, align 8
  %164 = fadd double %163, %161
  store double %164, ptr %162, align 8
  %165 = getelementptr inbounds i32, ptr @pp_spins, i64 %154
  %166 = getelementptr inbounds i8, ptr %165, i64 4
  %167 = load i32, ptr %166, align 4
  %168 = zext i32 %167 to i64
  %169 = getelementptr inbounds double, ptr %8, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = fmul double %98, %170
  %172 = getelementptr inbounds double, ptr %6, i64 %168
  %173 = load double, ptr %172, align 8
  %174 = fadd double %173, %171
  store double %174, ptr %172, align 8
  %175 = add nuw nsw i64 %154, 2
  %176 = add i64 %155, 2
  %177 = icmp eq i64 %176, %57
  br i1 %177, label %139, label %153

178:
  %179 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free_balancing, i64 %48) #17
  %180 = icmp eq i32 %179, 0
  br i1 %180, label %181, label %184

181:
  %182 = load i64, ptr %1, align 8
  %183 = add nsw i64 %182, 1
  store i64 %183, ptr %1, align 8
  br label %227

184:
  %185 = fadd double %94, %100
  br i1 %49, label %186, label %227

186:
  br i1 %61, label %215, label %187

187:
  %188 = phi i64 [ %211, %187 ], [ 0, %186 ]
  %189 = phi i64 [ %212, %187 ], [ 0, %186 ]
  %190 = shl nsw i64 %188, 3
  %191 = getelementptr inbounds i8, ptr @pp_balancing, i64 %190
  %192 = load i32, ptr %191, align 4
  %193 = zext i32 %192 to i64
  %194 = getelementptr inbounds double, ptr %10, i64 %193
  %195 = load double, ptr %194, align 8
  %196 = fmul double %100, %195
  %197 = getelementptr inbounds double, ptr %14, i64 %188
  %198 = load double, ptr %197, align 8
  %199 = fadd double %198, %196
  store double %199, ptr %197, align 8
  %200 = or i64 %188, 1
  %201 = shl nsw i64 %200, 3
  %202 = getelementptr inbounds i8, ptr @pp_balancing, i64 %201
  %203 = load i32, ptr %202, align 4
  %204 = zext i32 %203 to i64
  %205 = getelementptr inbounds double, ptr %10, i64 %204
  %206 = load double, ptr %205, align 8
  %207 = fmul double %100, %206
  %208 = getelementptr inbounds double, ptr %14, i64 %200
  %209 = load double, ptr %208, align 8
  %210 = fadd double %209, %207
  store double %210, ptr %208, align 8
  %211 = add nuw nsw i64 %188, 2
  %212 = add i64 %189, 2
  %213 = icmp eq i64 %212, %62
  br i1 %213, label %214, label %187

214:
  br i1 %63, label %227, label %215

215:
  %216 = phi i64 [ 0, %186 ], [ %211, %214 ]
  tail call void @llvm.assume(i1 %64)
  %217 = shl nsw i64 %216, 3
  %218 = getelementptr inbounds i8, ptr @pp_balancing, i64 %217
  %219 = load i32, ptr %218, align 4
  %220 = zext i32 %219 to i64
  %221 = getelementptr inbounds double, ptr %10, i64 %220
  %222 = load double, ptr %221, align 8
  %223 = fmul double %100, %222
  %224 = getelementptr inbounds double, ptr %14, i64 %216
  %225 = load double, ptr %224, align 8
  %226 = fadd double %225, %223
  store double %226, ptr %224, align 8
  br label %227

227:
  %228 = phi double [ %94, %93 ], [ %94, %181 ], [ %185, %184 ], [ %185, %214 ], [ %185, %215 ]
  %229 = add nuw nsw i64 %95, 1
  %230 = icmp slt i64 %229, %42
  br i1 %230, label %93, label %86

231:
  %232 = icmp eq i64 %89, 0
  br i1 %232, label %245, label %233

233:
  %234 = phi i64 [ 0, %88 ], [ %266, %231 ]
  %235 = icmp ne i64 %89, 0
  tail call void @llvm.assume(i1 %235)
  br label %236

236:
  %237 = phi i64 [ %242, %236 ], [ %234, %233 ]
  %238 = phi i64 [ %243, %236 ], [ 0, %233 ]
  %239 = getelementptr inbounds double, ptr %13, i64 %237
  %240 = load double, ptr %239, align 8
  %241 = getelementptr inbounds double, ptr %6, i64 %237
  store double %240, ptr %241, align 8
  %242 = add nuw nsw i64 %237, 1
  %243 = add i64 %238, 1
  %244 = icmp eq i64 %243, %89
  br i1 %244, label %245, label %236

245:
  %246 = fcmp ule double %87, 0.000000e+00
  %247 = select i1 %19, i1 %246, i1 false
  br i1 %247, label %269, label %333

248:
  %249 = phi i64 [ 0, %91 ], [ %266, %248 ]
  %250 = phi i64 [ 0, %91 ], [ %267, %248 ]
  %251 = getelementptr inbounds double, ptr %13, i64 %249
  %252 = load double, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %6, i64 %249
  store double %252, ptr %253, align 8
  %254 = or i64 %249, 1
  %255 = getelementptr inbounds double, ptr %13, i64 %254
  %256 = load double, ptr %255, align 8
  %257 = getelementptr inbounds double, ptr %6, i64 %254
  store double %256, ptr %257, align 8
  %258 = or i64 %249, 2
  %259 = getelementptr inbounds double, ptr %13, i64 %258
  %260 = load double, ptr %259, align 8
  %261 = getelementptr inbounds double, ptr %6, i64 %258
  store double %260, ptr %261, align 8
  %262 = or i64 %249, 3
  %263 = getelementptr inbounds double, ptr %13, i64 %262
  %264 = load double, ptr %263, align 8
  %265 = getelementptr inbounds double, ptr %6, i64 %262
  store double %264, ptr %265, align 8
  %266 = add nuw nsw i64 %249, 4
  %267 = add i64 %250, 4
  %268 = icmp eq i64 %267, %92
  br i1 %268, label %231, label %248

269:
  %270 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  %271 = icmp eq i64 %270, 1
  %272 = icmp sgt i64 %4, 0
  br i1 %272, label %273, label %356

273:
  %274 = and i64 %4, 3
  %275 = icmp ult i64 %4, 4
  br i1 %275, label %317, label %276

276:
  %277 = and i64 %4, 9223372036854775804
  br label %278

278:
  %279 = phi i64 [ 0, %276 ], [ %312, %278 ]
  %280 = phi i64 [ 0, %276 ], [ %313, %278 ]
  %281 = shl nsw i64 %279, 3
  %282 = getelementptr inbounds i8, ptr @pp_balancing, i64 %281
  %283 = load i32, ptr %282, align 4
  %284 = zext i32 %283 to i64
  %285 = getelementptr inbounds double, ptr %10, i64 %284
  %286 = load double, ptr %285, align 8
  %287 = getelementptr inbounds double, ptr %14, i64 %279
  store double %286, ptr %287, align 8
  %288 = or i64 %279, 1
  %289 = shl nsw i64 %288, 3
  %290 = getelementptr inbounds i8, ptr @pp_balancing, i64 %289
  %291 = load i32, ptr %290, align 4
  %292 = zext i32 %291 to i64
  %293 = getelementptr inbounds double, ptr %10, i64 %292
  %294 = load double, ptr %293, align 8
  %295 = getelementptr inbounds double, ptr %14, i64 %288
  store double %294, ptr %295, align 8
  %296 = or i64 %279, 2
  %297 = shl nsw i64 %296, 3
  %298 = getelementptr inbounds i8, ptr @pp_balancing, i64 %297
  %299 = load i32, ptr %298, align 4
  %300 = zext i32 %299 to i64
  %301 = getelementptr inbounds double, ptr %10, i64 %300
  %302 = load double, ptr %301, align 8
  %303 = getelementptr inbounds double, ptr %14, i64 %296
  store double %302, ptr %303, align 8
  %304 = or i64 %279, 3
  %305 = shl nsw i64 %304, 3
  %306 = getelementptr inbounds i8, ptr @pp_balancing, i64 %305
  %307 = load i32, ptr %306, align 4
  %308 = zext i32 %307 to i64
  %309 = getelementptr inbounds double, ptr %10, i64 %308
  %310 = load double, ptr %309, align 8
  %311 = getelementptr inbounds double, ptr %14, i64 %304
  store double %310, ptr %311, align 8
  %312 = add nuw nsw i64 %279, 4
  %313 = add i64 %280, 4
  %314 = icmp eq i64 %313, %277
  br i1 %314, label %315, label %278

315:
  %316 = icmp eq i64 %274, 0
  br i1 %316, label %333, label %317

317:
  %318 = phi i64 [ 0, %273 ], [ %312, %315 ]
  %319 = icmp ne i64 %274, 0
  tail call void @llvm.assume(i1 %319)
  br label %320

320:
  %321 = phi i64 [ %330, %320 ], [ %318, %317 ]
  %322 = phi i64 [ %331, %320 ], [ 0, %317 ]
  %323 = shl nsw i64 %321, 3
  %324 = getelementptr inbounds i8, ptr @pp_balancing, i64 %323
  %325 = load i32, ptr %324, align 4
  %326 = zext i32 %325 to i64
  %327 = getelementptr inbounds double, ptr %10, i64 %326
  %328 = load double, ptr %327, align 8
  %329 = getelementptr inbounds double, ptr %14, i64 %321
  store double %328, ptr %329, align 8
  %330 = add nuw nsw i64 %321, 1
  %331 = add i64 %322, 1
  %332 = icmp eq i64 %331, %274
  br i1 %332, label %333, label %320

333:
  %334 = phi i1 [ %19, %245 ], [ %271, %320 ], [ %271, %315 ]
  %335 = phi double [ %87, %245 ], [ 1.000000e+00, %320 ], [ 1.000000e+00, %315 ]
  %336 = icmp sgt i64 %4, 0
  %337 = and i1 %334, %336
  br i1 %337, label %338, label %356

338:
  %339 = getelementptr inbounds i8, ptr %0, i64 112
  br label %340

340:
  %341 = phi i64 [ 0, %338 ], [ %354, %340 ]
  %342 = shl nuw nsw i64 %341, 3
  %343 = getelementptr inbounds i8, ptr @pp_balancing, i64 %342
  %344 = getelementptr inbounds i8, ptr %343, i64 4
  %345 = load i32, ptr %344, align 4
  %346 = zext i32 %345 to i64
  %347 = getelementptr inbounds double, ptr %14, i64 %341
  %348 = load double, ptr %347, align 8
  %349 = fdiv double %348, %335
  %350 = load ptr, ptr %339, align 8
  %351 = getelementptr inbounds double, ptr %350, i64 %346
  %352 = load double, ptr %351, align 8
  %353 = fadd double %349, %352
  store double %353, ptr %351, align 8
  tail call fastcc void @put(ptr %0, i64 %346) #17
  %354 = add nuw nsw i64 %341, 1
  %355 = icmp slt i64 %354, %4
  br i1 %355, label %340, label %356

356:
  %357 = phi i1 [ %271, %269 ], [ %334, %333 ], [ %334, %340 ]
  tail call fastcc void @release(ptr %0, ptr %13) #17
  %358 = zext i1 %357 to i32
  br label %359

359:
  %360 = phi i32 [ %358, %356 ], [ 0, %2 ]
  ret i32 %360
}

define internal fastcc i32 @settle(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %5 = shl nsw i64 %2, 1
  %6 = add i64 %5, 6
  %7 = mul i64 %6, %2
  %8 = shl i64 %4, 4
  %9 = shl i64 %7, 3
  %10 = add i64 %8, %9
  %11 = tail call fastcc ptr @allocate(ptr %0, i64 %10) #17
  %12 = icmp eq ptr %11, null
  br i1 %12, label %754, label %13

13:
  %14 = mul i64 %2, %2
  %15 = getelementptr inbounds double, ptr %11, i64 %14
  %16 = getelementptr inbounds double, ptr %15, i64 %14
  %17 = getelementptr inbounds double, ptr %16, i64 %2
  %18 = getelementptr inbounds double, ptr %17, i64 %2
  %19 = getelementptr inbounds double, ptr %18, i64 %2
  %20 = getelementptr inbounds double, ptr %19, i64 %2
  %21 = getelementptr inbounds double, ptr %20, i64 %2
  %22 = getelementptr inbounds double, ptr %21, i64 %4
  %23 = getelementptr inbounds i64, ptr %22, i64 %4
  %24 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %25 = tail call fastcc ptr @reals(ptr %0, i64 %24) #17
  %26 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 152), align 8
  %27 = tail call fastcc ptr @reals(ptr %0, i64 %26) #17
  %28 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %29 = tail call fastcc ptr @reals(ptr %0, i64 %28) #17
  %30 = icmp slt i64 %4, 1
  br i1 %30, label %33, label %31

31:
  %32 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  br label %41

33:
  %34 = icmp sgt i64 %2, 0
  br i1 %34, label %35, label %66

35:
  %36 = add nsw i64 %2, -1
  %37 = and i64 %2, 3
  %38 = icmp ult i64 %36, 3
  br i1 %38, label %53, label %39

39:
  %40 = and i64 %2, 9223372036854775804
  br label %68

41:
  %42 = phi i64 [ 0, %31 ], [ %49, %41 ]
  %43 = getelementptr inbounds i64, ptr %22, i64 %42
  store i64 -1, ptr %43, align 8
  %44 = getelementptr inbounds double, ptr %25, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %21, i64 %42
  store double %45, ptr %46, align 8
  store double 0.000000e+00, ptr %44, align 8
  %47 = tail call fastcc ptr @reals(ptr %0, i64 %32) #17
  %48 = getelementptr inbounds double, ptr %47, i64 %42
  store double 0.000000e+00, ptr %48, align 8
  %49 = add nuw nsw i64 %42, 1
  %50 = icmp eq i64 %49, %4
  br i1 %50, label %33, label %41

51:
  %52 = icmp eq i64 %37, 0
  br i1 %52, label %66, label %53

53:
  %54 = phi i64 [ 0, %35 ], [ %90, %51 ]
  %55 = icmp ne i64 %37, 0
  tail call void @llvm.assume(i1 %55)
  br label %56

56:
  %57 = phi i64 [ %63, %56 ], [ %54, %53 ]
  %58 = phi i64 [ %64, %56 ], [ 0, %53 ]
  %59 = getelementptr inbounds i32, ptr %1, i64 %57
  %60 = load i32, ptr %59, align 4
  %61 = zext i32 %60 to i64
  %62 = getelementptr inbounds i64, ptr %22, i64 %61
  store i64 %57, ptr %62, align 8
  %63 = add nuw nsw i64 %57, 1
  %64 = add i64 %58, 1
  %65 = icmp eq i64 %64, %37
  br i1 %65, label %66, label %56

66:
  %67 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br i1 %30, label %125, label %93

68:
  %69 = phi i64 [ 0, %39 ], [ %90, %68 ]
  %70 = phi i64 [ 0, %39 ], [ %91, %68 ]
  %71 = getelementptr inbounds i32, ptr %1, i64 %69
  %72 = load i32, ptr %71, align 4
  %73 = zext i32 %72 to i64
  %74 = getelementptr inbounds i64, ptr %22, i64 %73
  store i64 %69, ptr %74, align 8
  %75 = or i64 %69, 1
  %76 = getelementptr inbounds i32, ptr %1, i64 %75
  %77 = load i32, ptr %76, align 4
  %78 = zext i32 %77 to i64
  %79 = getelementptr inbounds i64, ptr %22, i64 %78
  store i64 %75, ptr %79, align 8
  %80 = or i64 %69, 2
  %81 = getelementptr inbounds i32, ptr %1, i64 %80
  %82 = load i32, ptr %81, align 4
  %83 = zext i32 %82 to i64
  %84 = getelementptr inbounds i64, ptr %22, i64 %83
  store i64 %80, ptr %84, align 8
  %85 = or i64 %69, 3
  %86 = getelementptr inbounds i32, ptr %1, i64 %85
  %87 = load i32, ptr %86, align 4
  %88 = zext i32 %87 to i64
  %89 = getelementptr inbounds i64, ptr %22, i64 %88
  store i64 %85, ptr %89, align 8
  %90 = add nuw nsw i64 %69, 4
  %91 = add i64 %70, 4
  %92 = icmp eq i64 %91, %40
  br i1 %92, label %51, label %68

93:
  %94 = phi double [ %103, %93 ], [ 0.000000e+00, %66 ]
  %95 = phi i64 [ %104, %93 ], [ 0, %66 ]
  %96 = getelementptr inbounds double, ptr %27, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = tail call fastcc double @size_of(double %97) #17
  %99 = getelementptr inbounds double, ptr %29, i64 %95
  %100 = load double, ptr %99, align 8
  %101 = fdiv double %98, %100
  %102 = fcmp ogt double %101, %94
  %103 = select i1 %102, double %101, double %94
  %104 = add nuw nsw i64 %95, 1
  %105 = icmp eq i64 %104, %4
  br i1 %105, label %106, label %93

106:
  %107 = and i64 %4, 3
  %108 = icmp ult i64 %4, 4
  br i1 %108, label %113, label %109

109:
  %110 = and i64 %4, 9223372036854775804
  br label %128

111:
  %112 = icmp eq i64 %107, 0
  br i1 %112, label %125, label %113

113:
  %114 = phi i64 [ 0, %106 ], [ %146, %111 ]
  %115 = icmp ne i64 %107, 0
  tail call void @llvm.assume(i1 %115)
  br label %116

116:
  %117 = phi i64 [ %122, %116 ], [ %114, %113 ]
  %118 = phi i64 [ %123, %116 ], [ 0, %113 ]
  %119 = getelementptr inbounds double, ptr %21, i64 %117
  %120 = load double, ptr %119, align 8
  %121 = getelementptr inbounds double, ptr %25, i64 %117
  store double %120, ptr %121, align 8
  %122 = add nuw nsw i64 %117, 1
  %123 = add i64 %118, 1
  %124 = icmp eq i64 %123, %107
  br i1 %124, label %125, label %116

125:
  %126 = phi double [ 0.000000e+00, %66 ], [ %103, %116 ], [ %103, %111 ]
  %127 = icmp eq i64 %67, 1
  br i1 %127, label %149, label %152

128:
  %129 = phi i64 [ 0, %109 ], [ %146, %128 ]
  %130 = phi i64 [ 0, %109 ], [ %147, %128 ]
  %131 = getelementptr inbounds double, ptr %21, i64 %129
  %132 = load double, ptr %131, align 8
  %133 = getelementptr inbounds double, ptr %25, i64 %129
  store double %132, ptr %133, align 8
  %134 = or i64 %129, 1
  %135 = getelementptr inbounds double, ptr %21, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = getelementptr inbounds double, ptr %25, i64 %134
  store double %136, ptr %137, align 8
  %138 = or i64 %129, 2
  %139 = getelementptr inbounds double, ptr %21, i64 %138
  %140 = load double, ptr %139, align 8
  %141 = getelementptr inbounds double, ptr %25, i64 %138
  store double %140, ptr %141, align 8
  %142 = or i64 %129, 3
  %143 = getelementptr inbounds double, ptr %21, i64 %142
  %144 = load double, ptr %143, align 8
  %145 = getelementptr inbounds double, ptr %25, i64 %142
  store double %144, ptr %145, align 8
  %146 = add nuw nsw i64 %129, 4
  %147 = add i64 %130, 4
  %148 = icmp eq i64 %147, %110
  br i1 %148, label %111, label %128

149:
  %150 = tail call fastcc i64 @residual(ptr %0, i32 1, double 1.000000e+00, double 0.000000e+00) #17
  %151 = icmp eq i64 %150, 1
  br label %152

152:
  %153 = phi i1 [ %151, %149 ], [ false, %125 ]
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %34, label %154, label %176

154:
  %155 = add nuw i64 %2, 1
  %156 = add nsw i64 %2, -1
  %157 = and i64 %2, 3
  %158 = icmp ult i64 %156, 3
  br i1 %158, label %163, label %159

159:
  %160 = and i64 %2, 9223372036854775804
  br label %225

161:
  %162 = icmp eq i64 %157, 0
  br i1 %162, label %176, label %163

163:
  %164 = phi i64 [ 0, %154 ], [ %247, %161 ]
  %165 = icmp ne i64 %157, 0
  tail call void @llvm.assume(i1 %165)
  br label %166

166:
  %167 = phi i64 [ %164, %163 ], [ %173, %166 ]
  %168 = phi i64 [ 0, %163 ], [ %174, %166 ]
  %169 = mul i64 %167, %155
  %170 = getelementptr inbounds double, ptr %11, i64 %169
  %171 = load double, ptr %170, align 8
  %172 = getelementptr inbounds double, ptr %18, i64 %167
  store double %171, ptr %172, align 8
  %173 = add nuw nsw i64 %167, 1
  %174 = add i64 %168, 1
  %175 = icmp eq i64 %174, %157
  br i1 %175, label %176, label %166

176:
  br i1 %153, label %177, label %710

177:
  %178 = fmul double %126, 0x3D719799812DEA11
  %179 = icmp eq i64 %2, 0
  %180 = shl i64 %14, 3
  %181 = icmp slt i64 %2, 1
  %182 = tail call i64 @llvm.umax.i64(i64 %14, i64 1)
  %183 = add i64 %182, -1
  %184 = add i64 %2, -1
  %185 = and i64 %182, 1
  %186 = icmp ult i64 %14, 4
  %187 = and i64 %182, -4
  %188 = icmp eq i64 %185, 0
  %189 = icmp ne i64 %185, 0
  %190 = and i64 %182, 1
  %191 = icmp eq i64 %183, 0
  %192 = and i64 %182, -4
  %193 = icmp eq i64 %190, 0
  %194 = icmp ne i64 %190, 0
  %195 = and i64 %2, 3
  %196 = icmp ult i64 %184, 3
  %197 = and i64 %2, 9223372036854775804
  %198 = icmp eq i64 %195, 0
  %199 = icmp ne i64 %195, 0
  %200 = and i64 %182, 1
  %201 = icmp eq i64 %183, 0
  %202 = and i64 %182, -4
  %203 = icmp eq i64 %200, 0
  %204 = icmp ne i64 %200, 0
  %205 = and i64 %2, 3
  %206 = icmp ult i64 %184, 3
  %207 = and i64 %2, 9223372036854775804
  %208 = icmp eq i64 %205, 0
  %209 = icmp ne i64 %205, 0
  %210 = and i64 %2, 1
  %211 = icmp eq i64 %184, 0
  %212 = and i64 %2, 9223372036854775806
  %213 = icmp eq i64 %210, 0
  %214 = icmp ne i64 %210, 0
  %215 = and i64 %2, 3
  %216 = icmp ult i64 %184, 3
  %217 = and i64 %2, 9223372036854775804
  %218 = icmp eq i64 %215, 0
  %219 = icmp ne i64 %215, 0
  %220 = and i64 %2, 3
  %221 = icmp ult i64 %184, 3
  %222 = and i64 %2, 9223372036854775804
  %223 = icmp eq i64 %220, 0
  %224 = icmp ne i64 %220, 0
  br label %250

225:
  %226 = phi i64 [ 0, %159 ], [ %247, %225 ]
  %227 = phi i64 [ 0, %159 ], [ %248, %225 ]
  %228 = mul i64 %226, %155
  %229 = getelementptr inbounds double, ptr %11, i64 %228
  %230 = load double, ptr %229, align 8
  %231 = getelementptr inbounds double, ptr %18, i64 %226
  store double %230, ptr %231, align 8
  %232 = or i64 %226, 1
  %233 = mul i64 %232, %155
  %234 = getelementptr inbounds double, ptr %11, i64 %233
  %235 = load double, ptr %234, align 8
  %236 = getelementptr inbounds double, ptr %18, i64 %232
  store double %235, ptr %236, align 8
  %237 = or i64 %226, 2
  %238 = mul i64 %237, %155
  %239 = getelementptr inbounds double, ptr %11, i64 %238
  %240 = load double, ptr %239, align 8
  %241 = getelementptr inbounds double, ptr %18, i64 %237
  store double %240, ptr %241, align 8
  %242 = or i64 %226, 3
  %243 = mul i64 %242, %155
  %244 = getelementptr inbounds double, ptr %11, i64 %243
  %245 = load double, ptr %244, align 8
  %246 = getelementptr inbounds double, ptr %18, i64 %242
  store double %245, ptr %246, align 8
  %247 = add nuw nsw i64 %226, 4
  %248 = add i64 %227, 4
  %249 = icmp eq i64 %248, %160
  br i1 %249, label %161, label %225

250:
  %251 = phi double [ 1.000000e+04, %177 ], [ %645, %696 ]
  %252 = phi i64 [ 0, %177 ], [ %697, %696 ]
  %253 = phi i32 [ 1, %177 ], [ %638, %696 ]
  %254 = icmp eq i32 %253, 0
  br i1 %254, label %416, label %255

255:
  %256 = tail call fastcc i64 @residual(ptr %0, i32 1, double 0.000000e+00, double 1.000000e+00) #17
  %257 = icmp eq i64 %256, 1
  br i1 %257, label %258, label %710

258:
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %34, label %259, label %701

259:
  %260 = phi i64 [ %285, %266 ], [ 1, %258 ]
  %261 = phi i64 [ %286, %266 ], [ 0, %258 ]
  %262 = mul nuw nsw i64 %261, %2
  %263 = getelementptr double, ptr %11, i64 %262
  br label %288

264:
  %265 = icmp eq i64 %285, 0
  br i1 %265, label %307, label %701

266:
  %267 = getelementptr inbounds i32, ptr %1, i64 %261
  %268 = load i32, ptr %267, align 4
  %269 = zext i32 %268 to i64
  %270 = getelementptr inbounds double, ptr %29, i64 %269
  %271 = load double, ptr %270, align 8
  %272 = fmul double %178, %271
  %273 = fmul double %304, 1.800000e-15
  %274 = fcmp ogt double %273, %272
  %275 = select i1 %274, double %273, double %272
  %276 = getelementptr inbounds double, ptr %20, i64 %261
  store double %275, ptr %276, align 8
  %277 = load i32, ptr %267, align 4
  %278 = zext i32 %277 to i64
  %279 = getelementptr inbounds double, ptr %27, i64 %278
  %280 = load double, ptr %279, align 8
  %281 = getelementptr inbounds double, ptr %17, i64 %261
  store double %280, ptr %281, align 8
  %282 = tail call fastcc double @size_of(double %280) #17
  %283 = load double, ptr %276, align 8
  %284 = fcmp ugt double %282, %283
  %285 = select i1 %284, i64 0, i64 %260
  %286 = add nuw nsw i64 %261, 1
  %287 = icmp eq i64 %286, %2
  br i1 %287, label %264, label %259

288:
  %289 = phi i64 [ 0, %259 ], [ %305, %288 ]
  %290 = phi double [ 0.000000e+00, %259 ], [ %304, %288 ]
  %291 = getelementptr double, ptr %263, i64 %289
  %292 = load double, ptr %291, align 8
  %293 = tail call fastcc double @size_of(double %292) #17
  %294 = getelementptr inbounds i32, ptr %1, i64 %289
  %295 = load i32, ptr %294, align 4
  %296 = zext i32 %295 to i64
  %297 = getelementptr inbounds double, ptr %25, i64 %296
  %298 = load double, ptr %297, align 8
  %299 = tail call fastcc double @size_of(double %298) #17
  %300 = getelementptr inbounds double, ptr @pp_extents, i64 %296
  %301 = load double, ptr %300, align 8
  %302 = fadd double %299, %301
  %303 = fmul double %293, %302
  %304 = fadd double %290, %303
  %305 = add nuw nsw i64 %289, 1
  %306 = icmp eq i64 %305, %2
  br i1 %306, label %266, label %288

307:
  %308 = tail call fastcc i64 @residual(ptr %0, i32 1, double 1.000000e+00, double 0.000000e+00) #17
  %309 = icmp eq i64 %308, 1
  br i1 %309, label %310, label %710

310:
  br i1 %186, label %312, label %324

311:
  br i1 %188, label %323, label %312

312:
  %313 = phi i64 [ 0, %310 ], [ %342, %311 ]
  tail call void @llvm.assume(i1 %189)
  br label %314

314:
  %315 = phi i64 [ %320, %314 ], [ %313, %312 ]
  %316 = phi i64 [ %321, %314 ], [ 0, %312 ]
  %317 = getelementptr inbounds double, ptr %11, i64 %315
  %318 = load double, ptr %317, align 8
  %319 = getelementptr inbounds double, ptr %15, i64 %315
  store double %318, ptr %319, align 8
  %320 = add nuw nsw i64 %315, 1
  %321 = add i64 %316, 1
  %322 = icmp eq i64 %316, 0
  br i1 %322, label %323, label %314

323:
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %191, label %361, label %345

324:
  %325 = phi i64 [ %342, %324 ], [ 0, %310 ]
  %326 = phi i64 [ %343, %324 ], [ 0, %310 ]
  %327 = getelementptr inbounds double, ptr %11, i64 %325
  %328 = load double, ptr %327, align 8
  %329 = getelementptr inbounds double, ptr %15, i64 %325
  store double %328, ptr %329, align 8
  %330 = or i64 %325, 1
  %331 = getelementptr inbounds double, ptr %11, i64 %330
  %332 = load double, ptr %331, align 8
  %333 = getelementptr inbounds double, ptr %15, i64 %330
  store double %332, ptr %333, align 8
  %334 = or i64 %325, 2
  %335 = getelementptr inbounds double, ptr %11, i64 %334
  %336 = load double, ptr %335, align 8
  %337 = getelementptr inbounds double, ptr %15, i64 %334
  store double %336, ptr %337, align 8
  %338 = or i64 %325, 3
  %339 = getelementptr inbounds double, ptr %11, i64 %338
  %340 = load double, ptr %339, align 8
  %341 = getelementptr inbounds double, ptr %15, i64 %338
  store double %340, ptr %341, align 8
  %342 = add nuw nsw i64 %325, 4
  %343 = add i64 %326, 4
  %344 = icmp eq i64 %343, %187
  br i1 %344, label %311, label %324

345:
  %346 = phi i64 [ %357, %345 ], [ 0, %323 ]
  %347 = phi i64 [ %358, %345 ], [ 0, %323 ]
  %348 = getelementptr inbounds double, ptr %11, i64 %346
  %349 = load double, ptr %348, align 8
  %350 = getelementptr inbounds double, ptr %15, i64 %346
  %351 = load double, ptr %350, align 8
  store double %351, ptr %348, align 8
  store double %349, ptr %350, align 8
  %352 = or i64 %346, 1
  %353 = getelementptr inbounds double, ptr %11, i64 %352
  %354 = load double, ptr %353, align 8
  %355 = getelementptr inbounds double, ptr %15, i64 %352
  %356 = load double, ptr %355, align 8
  store double %356, ptr %353, align 8
  store double %354, ptr %355, align 8
  %357 = add nuw nsw i64 %346, 2
  %358 = add i64 %347, 2
  %359 = icmp eq i64 %358, %192
  br i1 %359, label %360, label %345

360:
  br i1 %193, label %367, label %361

361:
  %362 = phi i64 [ 0, %323 ], [ %357, %360 ]
  tail call void @llvm.assume(i1 %194)
  %363 = getelementptr inbounds double, ptr %11, i64 %362
  %364 = load double, ptr %363, align 8
  %365 = getelementptr inbounds double, ptr %15, i64 %362
  %366 = load double, ptr %365, align 8
  store double %366, ptr %363, align 8
  store double %364, ptr %365, align 8
  br label %367

367:
  br i1 %196, label %402, label %368

368:
  %369 = phi i64 [ %398, %368 ], [ 0, %367 ]
  %370 = phi i64 [ %399, %368 ], [ 0, %367 ]
  %371 = getelementptr inbounds i32, ptr %1, i64 %369
  %372 = load i32, ptr %371, align 4
  %373 = zext i32 %372 to i64
  %374 = getelementptr inbounds double, ptr %25, i64 %373
  %375 = load double, ptr %374, align 8
  %376 = getelementptr inbounds double, ptr %19, i64 %369
  store double %375, ptr %376, align 8
  %377 = or i64 %369, 1
  %378 = getelementptr inbounds i32, ptr %1, i64 %377
  %379 = load i32, ptr %378, align 4
  %380 = zext i32 %379 to i64
  %381 = getelementptr inbounds double, ptr %25, i64 %380
  %382 = load double, ptr %381, align 8
  %383 = getelementptr inbounds double, ptr %19, i64 %377
  store double %382, ptr %383, align 8
  %384 = or i64 %369, 2
  %385 = getelementptr inbounds i32, ptr %1, i64 %384
  %386 = load i32, ptr %385, align 4
  %387 = zext i32 %386 to i64
  %388 = getelementptr inbounds double, ptr %25, i64 %387
  %389 = load double, ptr %388, align 8
  %390 = getelementptr inbounds double, ptr %19, i64 %384
  store double %389, ptr %390, align 8
  %391 = or i64 %369, 3
  %392 = getelementptr inbounds i32, ptr %1, i64 %391
  %393 = load i32, ptr %392, align 4
  %394 = zext i32 %393 to i64
  %395 = getelementptr inbounds double, ptr %25, i64 %394
  %396 = load double, ptr %395, align 8
  %397 = getelementptr inbounds double, ptr %19, i64 %391
  store double %396, ptr %397, align 8
  %398 = add nuw nsw i64 %369, 4
  %399 = add i64 %370, 4
  %400 = icmp eq i64 %399, %197
  br i1 %400, label %401, label %368

401:
  br i1 %198, label %416, label %402

402:
  %403 = phi i64 [ 0, %367 ], [ %398, %401 ]
  tail call void @llvm.assume(i1 %199)
  br label %404

404:
  %405 = phi i64 [ %413, %404 ], [ %403, %402 ]
  %406 = phi i64 [ %414, %404 ], [ 0, %402 ]
  %407 = getelementptr inbounds i32, ptr %1, i64 %405
  %408 = load i32, ptr %407, align 4
  %409 = zext i32 %408 to i64
  %410 = getelementptr inbounds double, ptr %25, i64 %409
  %411 = load double, ptr %410, align 8
  %412 = getelementptr inbounds double, ptr %19, i64 %405
  store double %411, ptr %412, align 8
  %413 = add nuw nsw i64 %405, 1
  %414 = add i64 %406, 1
  %415 = icmp eq i64 %414, %195
  br i1 %415, label %416, label %404

416:
  %417 = tail call fastcc ptr @allocate(ptr %0, i64 %180) #17
  %418 = icmp eq ptr %417, null
  br i1 %418, label %710, label %419

419:
  br i1 %179, label %455, label %420

420:
  br i1 %201, label %422, label %434

421:
  br i1 %203, label %431, label %422

422:
  %423 = phi i64 [ 0, %420 ], [ %452, %421 ]
  tail call void @llvm.assume(i1 %204)
  %424 = getelementptr inbounds double, ptr %11, i64 %423
  %425 = load double, ptr %424, align 8
  %426 = getelementptr inbounds double, ptr %15, i64 %423
  %427 = load double, ptr %426, align 8
  %428 = fmul double %251, %427
  %429 = fadd double %425, %428
  %430 = getelementptr inbounds double, ptr %417, i64 %423
  store double %429, ptr %430, align 8
  br label %431

431:
  %432 = tail call fastcc i32 @factorise(ptr %417, i64 %2, ptr %23) #17
  br i1 %34, label %433, label %473

433:
  br i1 %206, label %459, label %475

434:
  %435 = phi i64 [ %452, %434 ], [ 0, %420 ]
  %436 = phi i64 [ %453, %434 ], [ 0, %420 ]
  %437 = getelementptr inbounds double, ptr %11, i64 %435
  %438 = load double, ptr %437, align 8
  %439 = getelementptr inbounds double, ptr %15, i64 %435
  %440 = load double, ptr %439, align 8
  %441 = fmul double %251, %440
  %442 = fadd double %438, %441
  %443 = getelementptr inbounds double, ptr %417, i64 %435
  store double %442, ptr %443, align 8
  %444 = or i64 %435, 1
  %445 = getelementptr inbounds double, ptr %11, i64 %444
  %446 = load double, ptr %445, align 8
  %447 = getelementptr inbounds double, ptr %15, i64 %444
  %448 = load double, ptr %447, align 8
  %449 = fmul double %251, %448
  %450 = fadd double %446, %449
  %451 = getelementptr inbounds double, ptr %417, i64 %444
  store double %450, ptr %451, align 8
  %452 = add nuw nsw i64 %435, 2
  %453 = add i64 %436, 2
  %454 = icmp eq i64 %453, %202
  br i1 %454, label %421, label %434

455:
  %456 = tail call fastcc i32 @factorise(ptr %417, i64 %2, ptr %23) #17
  %457 = icmp eq i32 %456, 0
  br i1 %457, label %637, label %501

458:
  br i1 %208, label %471, label %459

459:
  %460 = phi i64 [ 0, %433 ], [ %497, %458 ]
  tail call void @llvm.assume(i1 %209)
  br label %461

461:
  %462 = phi i64 [ %468, %461 ], [ %460, %459 ]
  %463 = phi i64 [ %469, %461 ], [ 0, %459 ]
  %464 = getelementptr inbounds double, ptr %17, i64 %462
  %465 = load double, ptr %464, align 8
  %466 = fneg double %465
  %467 = getelementptr inbounds double, ptr %16, i64 %462
  store double %466, ptr %467, align 8
  %468 = add nuw nsw i64 %462, 1
  %469 = add i64 %463, 1
  %470 = icmp eq i64 %469, %205
  br i1 %470, label %471, label %461

471:
  %472 = icmp eq i32 %432, 0
  br i1 %472, label %637, label %500

473:
  %474 = icmp eq i32 %432, 0
  br i1 %474, label %637, label %501

475:
  %476 = phi i64 [ %497, %475 ], [ 0, %433 ]
  %477 = phi i64 [ %498, %475 ], [ 0, %433 ]
  %478 = getelementptr inbounds double, ptr %17, i64 %476
  %479 = load double, ptr %478, align 8
  %480 = fneg double %479
  %481 = getelementptr inbounds double, ptr %16, i64 %476
  store double %480, ptr %481, align 8
  %482 = or i64 %476, 1
  %483 = getelementptr inbounds double, ptr %17, i64 %482
  %484 = load double, ptr %483, align 8
  %485 = fneg double %484
  %486 = getelementptr inbounds double, ptr %16, i64 %482
  store double %485, ptr %486, align 8
  %487 = or i64 %476, 2
  %488 = getelementptr inbounds double, ptr %17, i64 %487
  %489 = load double, ptr %488, align 8
  %490 = fneg double %489
  %491 = getelementptr inbounds double, ptr %16, i64 %487
  store double %490, ptr %491, align 8
  %492 = or i64 %476, 3
  %493 = getelementptr inbounds double, ptr %17, i64 %492
  %494 = load double, ptr %493, align 8
  %495 = fneg double %494
  %496 = getelementptr inbounds double, ptr %16, i64 %492
  store double %495, ptr %496, align 8
  %497 = add nuw nsw i64 %476, 4
  %498 = add i64 %477, 4
  %499 = icmp eq i64 %498, %207
  br i1 %499, label %458, label %475

500:
  tail call fastcc void @solve(ptr %417, i64 %2, ptr %23, ptr %16) #17
  br i1 %211, label %504, label %517

501:
  tail call fastcc void @solve(ptr %417, i64 %2, ptr %23, ptr %16) #17
  %502 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br label %557

503:
  br i1 %213, label %515, label %504

504:
  %505 = phi i64 [ 0, %500 ], [ %539, %503 ]
  tail call void @llvm.assume(i1 %214)
  %506 = getelementptr inbounds double, ptr %19, i64 %505
  %507 = load double, ptr %506, align 8
  %508 = getelementptr inbounds double, ptr %16, i64 %505
  %509 = load double, ptr %508, align 8
  %510 = fadd double %507, %509
  %511 = getelementptr inbounds i32, ptr %1, i64 %505
  %512 = load i32, ptr %511, align 4
  %513 = zext i32 %512 to i64
  %514 = getelementptr inbounds double, ptr %25, i64 %513
  store double %510, ptr %514, align 8
  br label %515

515:
  %516 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br i1 %216, label %543, label %560

517:
  %518 = phi i64 [ %539, %517 ], [ 0, %500 ]
  %519 = phi i64 [ %540, %517 ], [ 0, %500 ]
  %520 = getelementptr inbounds double, ptr %19, i64 %518
  %521 = load double, ptr %520, align 8
  %522 = getelementptr inbounds double, ptr %16, i64 %518
  %523 = load double, ptr %522, align 8
  %524 = fadd double %521, %523
  %525 = getelementptr inbounds i32, ptr %1, i64 %518
  %526 = load i32, ptr %525, align 4
  %527 = zext i32 %526 to i64
  %528 = getelementptr inbounds double, ptr %25, i64 %527
  store double %524, ptr %528, align 8
  %529 = or i64 %518, 1
  %530 = getelementptr inbounds double, ptr %19, i64 %529
  %531 = load double, ptr %530, align 8
  %532 = getelementptr inbounds double, ptr %16, i64 %529
  %533 = load double, ptr %532, align 8
  %534 = fadd double %531, %533
  %535 = getelementptr inbounds i32, ptr %1, i64 %529
  %536 = load i32, ptr %535, align 4
  %537 = zext i32 %536 to i64
  %538 = getelementptr inbounds double, ptr %25, i64 %537
  store double %534, ptr %538, align 8
  %539 = add nuw nsw i64 %518, 2
  %540 = add i64 %519, 2
  %541 = icmp eq i64 %540, %212
  br i1 %541, label %503, label %517

542:
  br i1 %218, label %557, label %543

543:
  %544 = phi i64 [ 0, %515 ], [ %590, %542 ]
  tail call void @llvm.assume(i1 %219)
  br label %545

545:
  %546 = phi i64 [ %554, %545 ], [ %544, %543 ]
  %547 = phi i64 [ %555, %545 ], [ 0, %543 ]
  %548 = getelementptr inbounds i32, ptr %1, i64 %546
  %549 = load i32, ptr %548, align 4
  %550 = zext i32 %549 to i64
  %551 = getelementptr inbounds double, ptr %27, i64 %550
  %552 = load double, ptr %551, align 8
  %553 = getelementptr inbounds double, ptr %20, i64 %546
  store double %552, ptr %553, align 8
  %554 = add nuw nsw i64 %546, 1
  %555 = add i64 %547, 1
  %556 = icmp eq i64 %555, %215
  br i1 %556, label %557, label %545

557:
  %558 = phi i64 [ %502, %501 ], [ %516, %545 ], [ %516, %542 ]
  %559 = icmp eq i64 %558, 1
  br i1 %559, label %593, label %637

560:
  %561 = phi i64 [ %590, %560 ], [ 0, %515 ]
  %562 = phi i64 [ %591, %560 ], [ 0, %515 ]
  %563 = getelementptr inbounds i32, ptr %1, i64 %561
  %564 = load i32, ptr %563, align 4
  %565 = zext i32 %564 to i64
  %566 = getelementptr inbounds double, ptr %27, i64 %565
  %567 = load double, ptr %566, align 8
  %568 = getelementptr inbounds double, ptr %20, i64 %561
  store double %567, ptr %568, align 8
  %569 = or i64 %561, 1
  %570 = getelementptr inbounds i32, ptr %1, i64 %569
  %571 = load i32, ptr %570, align 4
  %572 = zext i32 %571 to i64
  %573 = getelementptr inbounds double, ptr %27, i64 %572
  %574 = load double, ptr %573, align 8
  %575 = getelementptr inbounds double, ptr %20, i64 %569
  store double %574, ptr %575, align 8
  %576 = or i64 %561, 2
  %577 = getelementptr inbounds i32, ptr %1, i64 %576
  %578 = load i32, ptr %577, align 4
  %579 = zext i32 %578 to i64
  %580 = getelementptr inbounds double, ptr %27, i64 %579
  %581 = load double, ptr %580, align 8
  %582 = getelementptr inbounds double, ptr %20, i64 %576
  store double %581, ptr %582, align 8
  %583 = or i64 %561, 3
  %584 = getelementptr inbounds i32, ptr %1, i64 %583
  %585 = load i32, ptr %584, align 4
  %586 = zext i32 %585 to i64
  %587 = getelementptr inbounds double, ptr %27, i64 %586
  %588 = load double, ptr %587, align 8
  %589 = getelementptr inbounds double, ptr %20, i64 %583
  store double %588, ptr %589, align 8
  %590 = add nuw nsw i64 %561, 4
  %591 = add i64 %562, 4
  %592 = icmp eq i64 %591, %217
  br i1 %592, label %542, label %560

593:
  %594 = tail call fastcc i32 @all_finite(ptr %20, i64 %2) #17
  %595 = icmp eq i32 %594, 0
  br i1 %595, label %637, label %596

596:
  br i1 %34, label %606, label %599

597:
  %598 = fcmp ule double %615, 0.000000e+00
  br label %599

599:
  %600 = phi i1 [ true, %596 ], [ %598, %597 ]
  %601 = phi double [ 0.000000e+00, %596 ], [ %624, %597 ]
  tail call fastcc void @solve(ptr %417, i64 %2, ptr %23, ptr %20) #17
  %602 = tail call fastcc double @length_of(ptr %20, ptr %18, i64 %2) #17
  %603 = tail call fastcc double @length_of(ptr %16, ptr %18, i64 %2) #17
  %604 = fdiv double %602, %603
  %605 = fcmp olt double %604, 8.100000e-01
  br i1 %605, label %633, label %627

606:
  %607 = phi i64 [ %625, %606 ], [ 0, %596 ]
  %608 = phi double [ %624, %606 ], [ 0.000000e+00, %596 ]
  %609 = phi double [ %615, %606 ], [ 0.000000e+00, %596 ]
  %610 = getelementptr inbounds double, ptr %20, i64 %607
  %611 = load double, ptr %610, align 8
  %612 = getelementptr inbounds double, ptr %16, i64 %607
  %613 = load double, ptr %612, align 8
  %614 = fmul double %611, %613
  %615 = fadd double %609, %614
  %616 = tail call fastcc double @size_of(double %611) #17
  %617 = getelementptr inbounds i32, ptr %1, i64 %607
  %618 = load i32, ptr %617, align 4
  %619 = zext i32 %618 to i64
  %620 = getelementptr inbounds double, ptr %29, i64 %619
  %621 = load double, ptr %620, align 8
  %622 = fdiv double %616, %621
  %623 = fcmp ogt double %622, %608
  %624 = select i1 %623, double %622, double %608
  %625 = add nuw nsw i64 %607, 1
  %626 = icmp eq i64 %625, %2
  br i1 %626, label %597, label %606

627:
  %628 = fcmp ole double %601, %126
  %629 = select i1 %628, double 4.000000e+00, double 1.020000e+00
  %630 = fcmp ole double %604, %629
  %631 = select i1 %630, i1 %600, i1 false
  %632 = zext i1 %631 to i32
  br label %633

633:
  %634 = phi i32 [ 1, %599 ], [ %632, %627 ]
  %635 = fcmp olt double %604, 2.500000e-01
  %636 = select i1 %635, double 1.000000e-01, double 5.000000e-01
  br label %637

637:
  %638 = phi i32 [ 0, %455 ], [ %634, %633 ], [ 0, %593 ], [ 0, %557 ], [ 0, %473 ], [ 0, %471 ]
  %639 = phi double [ 5.000000e-01, %455 ], [ %636, %633 ], [ 5.000000e-01, %593 ], [ 5.000000e-01, %557 ], [ 5.000000e-01, %473 ], [ 5.000000e-01, %471 ]
  tail call fastcc void @release(ptr %0, ptr %417) #17
  %640 = icmp ne i32 %638, 0
  %641 = select i1 %640, double %639, double 8.000000e+00
  %642 = fmul double %251, %641
  %643 = fcmp olt double %642, 1.000000e-03
  %644 = select i1 %640, i1 %643, i1 false
  %645 = select i1 %644, double 1.000000e-03, double %642
  %646 = or i1 %640, %181
  br i1 %646, label %696, label %647

647:
  br i1 %221, label %682, label %648

648:
  %649 = phi i64 [ %678, %648 ], [ 0, %647 ]
  %650 = phi i64 [ %679, %648 ], [ 0, %647 ]
  %651 = getelementptr inbounds double, ptr %19, i64 %649
  %652 = load double, ptr %651, align 8
  %653 = getelementptr inbounds i32, ptr %1, i64 %649
  %654 = load i32, ptr %653, align 4
  %655 = zext i32 %654 to i64
  %656 = getelementptr inbounds double, ptr %25, i64 %655
  store double %652, ptr %656, align 8
  %657 = or i64 %649, 1
  %658 = getelementptr inbounds double, ptr %19, i64 %657
  %659 = load double, ptr %658, align 8
  %660 = getelementptr inbounds i32, ptr %1, i64 %657
  %661 = load i32, ptr %660, align 4
  %662 = zext i32 %661 to i64
  %663 = getelementptr inbounds double, ptr %25, i64 %662
  store double %659, ptr %663, align 8
  %664 = or i64 %649, 2
  %665 = getelementptr inbounds double, ptr %19, i64 %664
  %666 = load double, ptr %665, align 8
  %667 = getelementptr inbounds i32, ptr %1, i64 %664
  %668 = load i32, ptr %667, align 4
  %669 = zext i32 %668 to i64
  %670 = getelementptr inbounds double, ptr %25, i64 %669
  store double %666, ptr %670, align 8
  %671 = or i64 %649, 3
  %672 = getelementptr inbounds double, ptr %19, i64 %671
  %673 = load double, ptr %672, align 8
  %674 = getelementptr inbounds i32, ptr %1, i64 %671
  %675 = load i32, ptr %674, align 4
  %676 = zext i32 %675 to i64
  %677 = getelementptr inbounds double, ptr %25, i64 %676
  store double %673, ptr %677, align 8
  %678 = add nuw nsw i64 %649, 4
  %679 = add i64 %650, 4
  %680 = icmp eq i64 %679, %222
  br i1 %680, label %681, label %648

681:
  br i1 %223, label %696, label %682

682:
  %683 = phi i64 [ 0, %647 ], [ %678, %681 ]
  tail call void @llvm.assume(i1 %224)
  br label %684

684:
  %685 = phi i64 [ %693, %684 ], [ %683, %682 ]
  %686 = phi i64 [ %694, %684 ], [ 0, %682 ]
  %687 = getelementptr inbounds double, ptr %19, i64 %685
  %688 = load double, ptr %687, align 8
  %689 = getelementptr inbounds i32, ptr %1, i64 %685
  %690 = load i32, ptr %689, align 4
  %691 = zext i32 %690 to i64
  %692 = getelementptr inbounds double, ptr %25, i64 %691
  store double %688, ptr %692, align 8
  %693 = add nuw nsw i64 %685, 1
  %694 = add i64 %686, 1
  %695 = icmp eq i64 %694, %220
  br i1 %695, label %696, label %684

696:
  %697 = add nuw nsw i64 %252, 1
  %698 = icmp ult i64 %252, 199
  %699 = fcmp olt double %645, 1.000000e+20
  %700 = select i1 %698, i1 %699, i1 false
  br i1 %700, label %250, label %710

701:
  %702 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
  %703 = icmp eq i64 %702, 0
  br i1 %703, label %752, label %704

704:
  %705 = tail call fastcc i32 @in_gap(ptr %0) #17
  %706 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  %707 = icmp eq i32 %705, 0
  %708 = or i1 %707, %30
  %709 = xor i32 %705, 1
  br i1 %708, label %752, label %711

710:
  br i1 %30, label %752, label %711

711:
  %712 = add i64 %4, -1
  %713 = and i64 %4, 3
  %714 = icmp ult i64 %712, 3
  br i1 %714, label %740, label %715

715:
  %716 = and i64 %4, -4
  br label %717

717:
  %718 = phi i64 [ 0, %715 ], [ %735, %717 ]
  %719 = phi i64 [ 0, %715 ], [ %736, %717 ]
  %720 = getelementptr inbounds double, ptr %21, i64 %718
  %721 = load double, ptr %720, align 8
  %722 = getelementptr inbounds double, ptr %25, i64 %718
  store double %721, ptr %722, align 8
  %723 = or i64 %718, 1
  %724 = getelementptr inbounds double, ptr %21, i64 %723
  %725 = load double, ptr %724, align 8
  %726 = getelementptr inbounds double, ptr %25, i64 %723
  store double %725, ptr %726, align 8
  %727 = or i64 %718, 2
  %728 = getelementptr inbounds double, ptr %21, i64 %727
  %729 = load double, ptr %728, align 8
  %730 = getelementptr inbounds double, ptr %25, i64 %727
  store double %729, ptr %730, align 8
  %731 = or i64 %718, 3
  %732 = getelementptr inbounds double, ptr %21, i64 %731
  %733 = load double, ptr %732, align 8
  %734 = getelementptr inbounds double, ptr %25, i64 %731
  store double %733, ptr %734, align 8
  %735 = add nuw nsw i64 %718, 4
  %736 = add i64 %719, 4
  %737 = icmp eq i64 %736, %716
  br i1 %737, label %738, label %717

738:
  %739 = icmp eq i64 %713, 0
  br i1 %739, label %752, label %740

740:
  %741 = phi i64 [ 0, %711 ], [ %735, %738 ]
  %742 = icmp ne i64 %713, 0
  tail call void @llvm.assume(i1 %742)
  br label %743

743:
  %744 = phi i64 [ %749, %743 ], [ %741, %740 ]
  %745 = phi i64 [ %750, %743 ], [ 0, %740 ]
  %746 = getelementptr inbounds double, ptr %21, i64 %744
  %747 = load double, ptr %746, align 8
  %748 = getelementptr inbounds double, ptr %25, i64 %744
  store double %747, ptr %748, align 8
  %749 = add nuw nsw i64 %744, 1
  %750 = add i64 %745, 1
  %751 = icmp eq i64 %750, %713
  br i1 %751, label %752, label %743

752:
  %753 = phi i32 [ %709, %704 ], [ 1, %701 ], [ 0, %710 ], [ 0, %743 ], [ 0, %738 ]
  tail call fastcc void @release(ptr %0, ptr %11) #17
  br label %754

754:
  %755 = phi i32 [ %753, %752 ], [ 0, %3 ]
  ret i32 %755
}

define internal fastcc i64 @address(ptr %0) unnamed_addr #0 {
  %2 = ptrtoint ptr %0 to i64
  ret i64 %2
}

define internal fastcc i32 @refresh(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 72
  %3 = load i64, ptr %2, align 8
  switch i64 %3, label %15 [
    i64 0, label %29
    i64 2, label %4
  ]

4:
  %5 = getelementptr inbounds i8, ptr %0, i64 88
  %6 = load i64, ptr %5, align 8
  %7 = icmp eq i64 %6, 0
  br i1 %7, label %10, label %8

8:
  %9 = tail call fastcc i64 @request(ptr %0, i64 4, i64 0) #17
  br label %12

10:
  %11 = tail call fastcc i64 @restart(ptr %0) #17
  br label %12

12:
  %13 = phi i64 [ %11, %10 ], [ %9, %8 ]
  %14 = icmp eq i64 %13, 1
  br i1 %14, label %15, label %26

15:
  %16 = getelementptr inbounds i8, ptr %0, i64 120
  %17 = load ptr, ptr %16, align 8
  %18 = tail call fastcc i64 @address(ptr %17) #17
  %19 = tail call fastcc i64 @request(ptr %0, i64 2, i64 %18) #17
  %20 = icmp eq i64 %19, 1
  br i1 %20, label %21, label %26

21:
  %22 = load ptr, ptr %16, align 8
  %23 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  %24 = tail call fastcc i32 @all_finite(ptr %22, i64 %23) #17
  %25 = icmp eq i32 %24, 0
  br i1 %25, label %26, label %28

26:
  %27 = phi i64 [ %13, %12 ], [ %19, %15 ], [ 4, %21 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.46, i64 %27, ptr @.str.47) #17
  br label %29

28:
  store i64 0, ptr %2, align 8
  br label %29

29:
  %30 = phi i32 [ 0, %28 ], [ 3, %26 ], [ 0, %1 ]
  ret i32 %30
}

define internal fastcc ptr @reals(ptr %0, i64 %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 136
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 %1
  ret ptr %5
}

define internal fastcc i64 @residual(ptr %0, i32 %1, double %2, double %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 136
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %8 = getelementptr inbounds i8, ptr %6, i64 %7
  %9 = tail call fastcc double @now(ptr %0) #17
  store double %9, ptr %8, align 8
  %10 = zext i32 %1 to i64
  %11 = getelementptr inbounds i8, ptr %8, i64 32
  store i64 %10, ptr %11, align 8
  %12 = getelementptr inbounds i8, ptr %8, i64 24
  store double %2, ptr %12, align 8
  %13 = getelementptr inbounds i8, ptr %8, i64 16
  store double 0.000000e+00, ptr %13, align 8
  %14 = getelementptr inbounds i8, ptr %8, i64 8
  store double %3, ptr %14, align 8
  %15 = load ptr, ptr getelementptr inbounds (i8, ptr @pp_entries, i64 8), align 8
  %16 = tail call fastcc i64 @address(ptr %8) #17
  %17 = tail call i64 %15(i64 %16, i64 1, i64 0) #19
  ret i64 %17
}

define internal fastcc void @put(ptr %0, i64 %1) unnamed_addr #9 {
  %3 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %1
  %4 = getelementptr inbounds i8, ptr %3, i64 8
  %5 = load i64, ptr %4, align 8
  %6 = getelementptr inbounds %struct.Place, ptr @pp_places, i64 %5
  %7 = getelementptr inbounds i8, ptr %3, i64 16
  %8 = load i64, ptr %7, align 8
  %9 = mul nsw i64 %8, 40
  %10 = getelementptr inbounds i8, ptr %6, i64 %9
  %11 = icmp sgt i64 %8, 0
  br i1 %11, label %12, label %21

12:
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %14 = icmp sgt i64 %13, 0
  br label %15

15:
  %16 = phi ptr [ %6, %12 ], [ %67, %62 ]
  %17 = getelementptr inbounds i8, ptr %16, i64 24
  %18 = load i64, ptr %17, align 8
  %19 = icmp ne i64 %18, 0
  %20 = select i1 %19, i1 %14, i1 false
  br i1 %20, label %26, label %22

21:
  ret void

22:
  %23 = phi double [ 0.000000e+00, %15 ], [ %57, %56 ]
  %24 = getelementptr inbounds i8, ptr %16, i64 32
  %25 = load double, ptr %24, align 8
  br i1 %19, label %62, label %60

26:
  %27 = phi i64 [ %58, %56 ], [ 0, %15 ]
  %28 = phi double [ %57, %56 ], [ 0.000000e+00, %15 ]
  %29 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %27
  %30 = load i64, ptr %29, align 8
  %31 = add i64 %30, -1
  %32 = icmp ult i64 %31, 2
  br i1 %32, label %33, label %56

33:
  %34 = getelementptr inbounds i8, ptr %29, i64 8
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds %struct.Place, ptr @pp_places, i64 %35
  %37 = getelementptr inbounds i8, ptr %29, i64 16
  %38 = load i64, ptr %37, align 8
  %39 = mul nsw i64 %38, 40
  %40 = getelementptr inbounds i8, ptr %36, i64 %39
  %41 = icmp sgt i64 %38, 0
  br i1 %41, label %42, label %56

42:
  %43 = load i64, ptr %16, align 8
  br label %44

44:
  %45 = phi ptr [ %36, %42 ], [ %54, %52 ]
  %46 = phi double [ %28, %42 ], [ %53, %52 ]
  %47 = load i64, ptr %45, align 8
  %48 = icmp eq i64 %47, %43
  br i1 %48, label %49, label %52

49:
  %50 = tail call fastcc double @change_by(ptr %0, i64 %27, ptr %45) #17
  %51 = fadd double %46, %50
  br label %52

52:
  %53 = phi double [ %51, %49 ], [ %46, %44 ]
  %54 = getelementptr inbounds i8, ptr %45, i64 40
  %55 = icmp ult ptr %54, %40
  br i1 %55, label %44, label %56

56:
  %57 = phi double [ %28, %26 ], [ %28, %33 ], [ %53, %52 ]
  %58 = add nuw nsw i64 %27, 1
  %59 = icmp slt i64 %58, %13
  br i1 %59, label %26, label %22

60:
  %61 = tail call fastcc double @change_by(ptr %0, i64 %1, ptr %16) #17
  br label %62

62:
  %63 = phi double [ %61, %60 ], [ %23, %22 ]
  %64 = fadd double %25, %63
  %65 = load i64, ptr %16, align 8
  %66 = tail call fastcc ptr @reals(ptr %0, i64 %65) #17
  store double %64, ptr %66, align 8
  %67 = getelementptr inbounds i8, ptr %16, i64 40
  %68 = icmp ult ptr %67, %10
  br i1 %68, label %15, label %21
}

define internal fastcc double @change_by(ptr %0, i64 %1, ptr %2) unnamed_addr #10 {
  %4 = getelementptr inbounds i8, ptr %0, i64 112
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds double, ptr %5, i64 %1
  %7 = load double, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %1
  %9 = getelementptr inbounds i8, ptr %8, i64 24
  %10 = load double, ptr %9, align 8
  %11 = fsub double %7, %10
  %12 = getelementptr inbounds i8, ptr %2, i64 8
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %2, i64 16
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %17, label %19

17:
  %18 = add nsw i64 %15, %13
  br label %21

19:
  %20 = phi double [ 0.000000e+00, %3 ], [ %28, %21 ]
  ret double %20

21:
  %22 = phi i64 [ %24, %21 ], [ %18, %17 ]
  %23 = phi double [ %28, %21 ], [ 0.000000e+00, %17 ]
  %24 = add nsw i64 %22, -1
  %25 = getelementptr inbounds double, ptr @pp_coefficients, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fadd double %23, %26
  %28 = fmul double %11, %27
  %29 = icmp sgt i64 %24, %13
  br i1 %29, label %21, label %19
}

define internal fastcc double @size_of(double %0) unnamed_addr #0 {
  %2 = fcmp olt double %0, 0.000000e+00
  %3 = fneg double %0
  %4 = select i1 %2, double %3, double %0
  ret double %4
}

define internal fastcc void @gather(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #11 {
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 160), align 8
  %6 = tail call fastcc ptr @reals(ptr %0, i64 %5) #17
  %7 = icmp eq i64 %2, 0
  br i1 %7, label %27, label %8

8:
  %9 = mul i64 %2, %2
  %10 = tail call i64 @llvm.umax.i64(i64 %9, i64 1)
  %11 = and i64 %10, 5
  %12 = icmp ult i64 %9, 8
  br i1 %12, label %17, label %13

13:
  %14 = and i64 %10, -8
  br label %30

15:
  %16 = icmp eq i64 %11, 0
  br i1 %16, label %27, label %17

17:
  %18 = phi i64 [ 0, %8 ], [ %48, %15 ]
  %19 = icmp ne i64 %11, 0
  tail call void @llvm.assume(i1 %19)
  br label %20

20:
  %21 = phi i64 [ %24, %20 ], [ %18, %17 ]
  %22 = phi i64 [ %25, %20 ], [ 0, %17 ]
  %23 = getelementptr inbounds double, ptr %3, i64 %21
  store double 0.000000e+00, ptr %23, align 8
  %24 = add nuw nsw i64 %21, 1
  %25 = add i64 %22, 1
  %26 = icmp eq i64 %25, %11
  br i1 %26, label %27, label %20

27:
  %28 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 48), align 8
  %29 = icmp sgt i64 %28, 0
  br i1 %29, label %52, label %51

30:
  %31 = phi i64 [ 0, %13 ], [ %48, %30 ]
  %32 = phi i64 [ 0, %13 ], [ %49, %30 ]
  %33 = getelementptr inbounds double, ptr %3, i64 %31
  store double 0.000000e+00, ptr %33, align 8
  %34 = getelementptr inbounds double, ptr %3, i64 %31
  %35 = getelementptr inbounds i8, ptr %34, i64 8
  store double 0.000000e+00, ptr %35, align 8
  %36 = getelementptr inbounds double, ptr %3, i64 %31
  %37 = getelementptr inbounds i8, ptr %36, i64 16
  store double 0.000000e+00, ptr %37, align 8
  %38 = getelementptr inbounds double, ptr %3, i64 %31
  %39 = getelementptr inbounds i8, ptr %38, i64 24
  store double 0.000000e+00, ptr %39, align 8
  %40 = getelementptr inbounds double, ptr %3, i64 %31
  %41 = getelementptr inbounds i8, ptr %40, i64 32
  store double 0.000000e+00, ptr %41, align 8
  %42 = getelementptr inbounds double, ptr %3, i64 %31
  %43 = getelementptr inbounds i8, ptr %42, i64 40
  store double 0.000000e+00, ptr %43, align 8
  %44 = getelementptr inbounds double, ptr %3, i64 %31
  %45 = getelementptr inbounds i8, ptr %44, i64 48
  store double 0.000000e+00, ptr %45, align 8
  %46 = getelementptr inbounds double, ptr %3, i64 %31
  %47 = getelementptr inbounds i8, ptr %46, i64 56
  store double 0.000000e+00, ptr %47, align 8
  %48 = add nuw nsw i64 %31, 8
  %49 = add i64 %32, 8
  %50 = icmp eq i64 %49, %14
  br i1 %50, label %15, label %30

51:
  ret void

52:
  %53 = phi i64 [ %78, %77 ], [ 0, %27 ]
  %54 = mul nuw nsw i64 %53, 12
  %55 = getelementptr inbounds i8, ptr @pp_entries_of_matrix, i64 %54
  %56 = load i32, ptr %55, align 4
  %57 = zext i32 %56 to i64
  %58 = getelementptr inbounds i64, ptr %1, i64 %57
  %59 = load i64, ptr %58, align 8
  %60 = getelementptr inbounds i8, ptr %55, i64 4
  %61 = load i32, ptr %60, align 4
  %62 = zext i32 %61 to i64
  %63 = getelementptr inbounds i64, ptr %1, i64 %62
  %64 = load i64, ptr %63, align 8
  %65 = icmp sgt i64 %59, -1
  %66 = icmp sgt i64 %64, -1
  %67 = select i1 %65, i1 %66, i1 false
  br i1 %67, label %68, label %77

68:
  %69 = getelementptr inbounds i8, ptr %55, i64 8
  %70 = load i32, ptr %69, align 4
  %71 = zext i32 %70 to i64
  %72 = getelementptr inbounds double, ptr %6, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = mul nsw i64 %59, %2
  %75 = getelementptr double, ptr %3, i64 %74
  %76 = getelementptr double, ptr %75, i64 %64
  store double %73, ptr %76, align 8
  br label %77

77:
  %78 = add nuw nsw i64 %53, 1
  %79 = icmp eq i64 %78, %28
  br i1 %79, label %51, label %52
}

define internal fastcc i32 @factorise(ptr %0, i64 %1, ptr %2) unnamed_addr #12 {
  %4 = icmp sgt i64 %1, 0
  br i1 %4, label %5, label %118

5:
  %6 = add nsw i64 %1, -1
  %7 = add nsw i64 %1, -2
  %8 = and i64 %1, 1
  %9 = icmp eq i64 %6, 0
  %10 = and i64 %1, 9223372036854775806
  %11 = icmp eq i64 %8, 0
  %12 = icmp ne i64 %8, 0
  br label %15

13:
  %14 = icmp eq i64 %18, %1
  br i1 %14, label %118, label %15

15:
  %16 = phi i64 [ %18, %13 ], [ 0, %5 ]
  %17 = sub i64 %6, %16
  %18 = add nuw nsw i64 %16, 1
  %19 = getelementptr double, ptr %0, i64 %16
  %20 = icmp slt i64 %18, %1
  br i1 %20, label %35, label %21

21:
  %22 = phi i64 [ %16, %15 ], [ %47, %35 ]
  %23 = getelementptr inbounds i64, ptr %2, i64 %16
  store i64 %22, ptr %23, align 8
  %24 = mul nsw i64 %22, %1
  %25 = getelementptr double, ptr %0, i64 %24
  %26 = getelementptr double, ptr %25, i64 %16
  %27 = load double, ptr %26, align 8
  %28 = tail call fastcc double @size_of(double %27) #17
  %29 = fcmp ogt double %28, 1.000000e-300
  br i1 %29, label %30, label %118

30:
  %31 = icmp eq i64 %22, %16
  br i1 %31, label %57, label %32

32:
  %33 = mul nuw nsw i64 %16, %1
  %34 = getelementptr double, ptr %0, i64 %33
  br i1 %9, label %51, label %67

35:
  %36 = phi i64 [ %48, %35 ], [ %18, %15 ]
  %37 = phi i64 [ %47, %35 ], [ %16, %15 ]
  %38 = mul nuw nsw i64 %36, %1
  %39 = getelementptr double, ptr %19, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = tail call fastcc double @size_of(double %40) #17
  %42 = mul nsw i64 %37, %1
  %43 = getelementptr double, ptr %19, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = tail call fastcc double @size_of(double %44) #17
  %46 = fcmp ogt double %41, %45
  %47 = select i1 %46, i64 %36, i64 %37
  %48 = add nuw nsw i64 %36, 1
  %49 = icmp eq i64 %48, %1
  br i1 %49, label %21, label %35

50:
  br i1 %11, label %57, label %51

51:
  %52 = phi i64 [ 0, %32 ], [ %79, %50 ]
  tail call void @llvm.assume(i1 %12)
  %53 = getelementptr double, ptr %34, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = getelementptr double, ptr %25, i64 %52
  %56 = load double, ptr %55, align 8
  store double %56, ptr %53, align 8
  store double %54, ptr %55, align 8
  br label %57

57:
  br i1 %20, label %58, label %13

58:
  %59 = mul nuw nsw i64 %16, %1
  %60 = getelementptr double, ptr %0, i64 %59
  %61 = getelementptr double, ptr %60, i64 %16
  %62 = and i64 %17, 1
  %63 = icmp eq i64 %62, 0
  %64 = getelementptr double, ptr %60, i64 %18
  %65 = add nuw nsw i64 %16, 2
  %66 = icmp eq i64 %7, %16
  br label %82

67:
  %68 = phi i64 [ %79, %67 ], [ 0, %32 ]
  %69 = phi i64 [ %80, %67 ], [ 0, %32 ]
  %70 = getelementptr double, ptr %34, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = getelementptr double, ptr %25, i64 %68
  %73 = load double, ptr %72, align 8
  store double %73, ptr %70, align 8
  store double %71, ptr %72, align 8
  %74 = or i64 %68, 1
  %75 = getelementptr double, ptr %34, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = getelementptr double, ptr %25, i64 %74
  %78 = load double, ptr %77, align 8
  store double %78, ptr %75, align 8
  store double %76, ptr %77, align 8
  %79 = add nuw nsw i64 %68, 2
  %80 = add i64 %69, 2
  %81 = icmp eq i64 %80, %10
  br i1 %81, label %50, label %67

82:
  %83 = phi i64 [ %18, %58 ], [ %99, %98 ]
  %84 = load double, ptr %61, align 8
  %85 = mul nuw nsw i64 %83, %1
  %86 = getelementptr double, ptr %0, i64 %85
  %87 = getelementptr double, ptr %86, i64 %16
  %88 = load double, ptr %87, align 8
  %89 = fdiv double %88, %84
  store double %89, ptr %87, align 8
  br i1 %63, label %96, label %90

90:
  %91 = load double, ptr %64, align 8
  %92 = fmul double %89, %91
  %93 = getelementptr double, ptr %86, i64 %18
  %94 = load double, ptr %93, align 8
  %95 = fsub double %94, %92
  store double %95, ptr %93, align 8
  br label %96

96:
  %97 = phi i64 [ %18, %82 ], [ %65, %90 ]
  br i1 %66, label %98, label %101

98:
  %99 = add nuw nsw i64 %83, 1
  %100 = icmp eq i64 %99, %1
  br i1 %100, label %13, label %82

101:
  %102 = phi i64 [ %116, %101 ], [ %97, %96 ]
  %103 = getelementptr double, ptr %60, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = fmul double %89, %104
  %106 = getelementptr double, ptr %86, i64 %102
  %107 = load double, ptr %106, align 8
  %108 = fsub double %107, %105
  store double %108, ptr %106, align 8
  %109 = add nuw nsw i64 %102, 1
  %110 = getelementptr double, ptr %60, i64 %109
  %111 = load double, ptr %110, align 8
  %112 = fmul double %89, %111
  %113 = getelementptr double, ptr %86, i64 %109
  %114 = load double, ptr %113, align 8
  %115 = fsub double %114, %112
  store double %115, ptr %113, align 8
  %116 = add nuw nsw i64 %102, 2
  %117 = icmp eq i64 %116, %1
  br i1 %117, label %98, label %101

118:
  %119 = phi i32 [ 1, %3 ], [ 0, %21 ], [ 1, %13 ]
  ret i32 %119
}

define internal fastcc void @solve(ptr %0, i64 %1, ptr %2, ptr %3) unnamed_addr #12 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %120

6:
  %7 = and i64 %1, 1
  %8 = icmp eq i64 %1, 1
  br i1 %8, label %13, label %9

9:
  %10 = and i64 %1, 9223372036854775806
  br label %24

11:
  %12 = icmp eq i64 %7, 0
  br i1 %12, label %22, label %13

13:
  %14 = phi i64 [ 0, %6 ], [ %40, %11 ]
  %15 = icmp ne i64 %7, 0
  tail call void @llvm.assume(i1 %15)
  %16 = getelementptr inbounds i64, ptr %2, i64 %14
  %17 = load i64, ptr %16, align 8
  %18 = getelementptr inbounds double, ptr %3, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = getelementptr inbounds double, ptr %3, i64 %14
  %21 = load double, ptr %20, align 8
  store double %21, ptr %18, align 8
  store double %19, ptr %20, align 8
  br label %22

22:
  %23 = icmp eq i64 %1, 1
  br i1 %23, label %54, label %43

24:
  %25 = phi i64 [ 0, %9 ], [ %40, %24 ]
  %26 = phi i64 [ 0, %9 ], [ %41, %24 ]
  %27 = getelementptr inbounds i64, ptr %2, i64 %25
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %3, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %3, i64 %25
  %32 = load double, ptr %31, align 8
  store double %32, ptr %29, align 8
  store double %30, ptr %31, align 8
  %33 = or i64 %25, 1
  %34 = getelementptr inbounds i64, ptr %2, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %3, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds double, ptr %3, i64 %33
  %39 = load double, ptr %38, align 8
  store double %39, ptr %36, align 8
  store double %37, ptr %38, align 8
  %40 = add nuw nsw i64 %25, 2
  %41 = add i64 %26, 2
  %42 = icmp eq i64 %41, %10
  br i1 %42, label %11, label %24

43:
  %44 = phi i64 [ %71, %68 ], [ 0, %22 ]
  %45 = phi i64 [ %69, %68 ], [ 1, %22 ]
  %46 = mul nuw nsw i64 %45, %1
  %47 = getelementptr double, ptr %0, i64 %46
  %48 = getelementptr inbounds double, ptr %3, i64 %45
  %49 = load double, ptr %48, align 8
  %50 = and i64 %45, 1
  %51 = icmp eq i64 %44, 0
  br i1 %51, label %58, label %52

52:
  %53 = and i64 %45, 9223372036854775806
  br label %72

54:
  %55 = add nuw i64 %1, 1
  br label %92

56:
  %57 = icmp eq i64 %50, 0
  br i1 %57, label %68, label %58

58:
  %59 = phi i64 [ 0, %43 ], [ %89, %56 ]
  %60 = phi double [ %49, %43 ], [ %88, %56 ]
  %61 = icmp ne i64 %50, 0
  tail call void @llvm.assume(i1 %61)
  %62 = getelementptr double, ptr %47, i64 %59
  %63 = load double, ptr %62, align 8
  %64 = getelementptr inbounds double, ptr %3, i64 %59
  %65 = load double, ptr %64, align 8
  %66 = fmul double %63, %65
  %67 = fsub double %60, %66
  store double %67, ptr %48, align 8
  br label %68

68:
  %69 = add nuw nsw i64 %45, 1
  %70 = icmp eq i64 %69, %1
  %71 = add i64 %44, 1
  br i1 %70, label %54, label %43

72:
  %73 = phi i64 [ 0, %52 ], [ %89, %72 ]
  %74 = phi double [ %49, %52 ], [ %88, %72 ]
  %75 = phi i64 [ 0, %52 ], [ %90, %72 ]
  %76 = getelementptr double, ptr %47, i64 %73
  %77 = load double, ptr %76, align 8
  %78 = getelementptr inbounds double, ptr %3, i64 %73
  %79 = load double, ptr %78, align 8
  %80 = fmul double %77, %79
  %81 = fsub double %74, %80
  store double %81, ptr %48, align 8
  %82 = or i64 %73, 1
  %83 = getelementptr double, ptr %47, i64 %82
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds double, ptr %3, i64 %82
  %86 = load double, ptr %85, align 8
  %87 = fmul double %84, %86
  %88 = fsub double %81, %87
  store double %88, ptr %48, align 8
  %89 = add nuw nsw i64 %73, 2
  %90 = add i64 %75, 2
  %91 = icmp eq i64 %90, %53
  br i1 %91, label %56, label %72

92:
  %93 = phi i64 [ 0, %54 ], [ %129, %121 ]
  %94 = phi i64 [ %1, %54 ], [ %95, %121 ]
  %95 = add nsw i64 %94, -1
  %96 = icmp slt i64 %94, %1
  br i1 %96, label %100, label %97

97:
  %98 = getelementptr inbounds double, ptr %3, i64 %95
  %99 = load double, ptr %98, align 8
  br label %121

100:
  %101 = mul nsw i64 %95, %1
  %102 = getelementptr double, ptr %0, i64 %101
  %103 = getelementptr inbounds double, ptr %3, i64 %95
  %104 = load double, ptr %103, align 8
  %105 = and i64 %93, 1
  %106 = icmp eq i64 %105, 0
  br i1 %106, label %115, label %107

107:
  %108 = getelementptr double, ptr %102, i64 %94
  %109 = load double, ptr %108, align 8
  %110 = getelementptr inbounds double, ptr %3, i64 %94
  %111 = load double, ptr %110, align 8
  %112 = fmul double %109, %111
  %113 = fsub double %104, %112
  store double %113, ptr %103, align 8
  %114 = add nuw nsw i64 %94, 1
  br label %115

115:
  %116 = phi double [ poison, %100 ], [ %113, %107 ]
  %117 = phi double [ %104, %100 ], [ %113, %107 ]
  %118 = phi i64 [ %94, %100 ], [ %114, %107 ]
  %119 = icmp eq i64 %93, 1
  br i1 %119, label %121, label %130

120:
  ret void

121:
  %122 = phi double [ %99, %97 ], [ %116, %115 ], [ %145, %130 ]
  %123 = mul i64 %95, %55
  %124 = getelementptr inbounds double, ptr %0, i64 %123
  %125 = load double, ptr %124, align 8
  %126 = getelementptr inbounds double, ptr %3, i64 %95
  %127 = fdiv double %122, %125
  store double %127, ptr %126, align 8
  %128 = icmp ugt i64 %94, 1
  %129 = add i64 %93, 1
  br i1 %128, label %92, label %120

130:
  %131 = phi double [ %145, %130 ], [ %117, %115 ]
  %132 = phi i64 [ %146, %130 ], [ %118, %115 ]
  %133 = getelementptr double, ptr %102, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %3, i64 %132
  %136 = load double, ptr %135, align 8
  %137 = fmul double %134, %136
  %138 = fsub double %131, %137
  store double %138, ptr %103, align 8
  %139 = add nuw nsw i64 %132, 1
  %140 = getelementptr double, ptr %102, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds double, ptr %3, i64 %139
  %143 = load double, ptr %142, align 8
  %144 = fmul double %141, %143
  %145 = fsub double %138, %144
  store double %145, ptr %103, align 8
  %146 = add nuw nsw i64 %132, 2
  %147 = icmp eq i64 %146, %1
  br i1 %147, label %121, label %130
}

define internal fastcc i32 @all_finite(ptr %0, i64 %1) unnamed_addr #6 {
  %3 = icmp sgt i64 %1, 0
  br i1 %3, label %7, label %13

4:
  %5 = add nuw nsw i64 %8, 1
  %6 = icmp eq i64 %5, %1
  br i1 %6, label %13, label %7

7:
  %8 = phi i64 [ %5, %4 ], [ 0, %2 ]
  %9 = getelementptr inbounds double, ptr %0, i64 %8
  %10 = load double, ptr %9, align 8
  %11 = tail call fastcc i32 @finite_number(double %10) #17
  %12 = icmp eq i32 %11, 0
  br i1 %12, label %13, label %4

13:
  %14 = phi i32 [ 1, %2 ], [ 1, %4 ], [ 0, %7 ]
  ret i32 %14
}

define internal fastcc double @length_of(ptr %0, ptr %1, i64 %2) unnamed_addr #6 {
  %4 = icmp sgt i64 %2, 0
  br i1 %4, label %5, label %30

5:
  %6 = and i64 %2, 3
  %7 = icmp ult i64 %2, 4
  br i1 %7, label %12, label %8

8:
  %9 = and i64 %2, 9223372036854775804
  br label %32

10:
  %11 = icmp eq i64 %6, 0
  br i1 %11, label %30, label %12

12:
  %13 = phi i64 [ 0, %5 ], [ %67, %10 ]
  %14 = phi double [ 0.000000e+00, %5 ], [ %66, %10 ]
  %15 = icmp ne i64 %6, 0
  tail call void @llvm.assume(i1 %15)
  br label %16

16:
  %17 = phi i64 [ %27, %16 ], [ %13, %12 ]
  %18 = phi double [ %26, %16 ], [ %14, %12 ]
  %19 = phi i64 [ %28, %16 ], [ 0, %12 ]
  %20 = getelementptr inbounds double, ptr %1, i64 %17
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %0, i64 %17
  %23 = load double, ptr %22, align 8
  %24 = fmul double %21, %23
  %25 = fmul double %23, %24
  %26 = fadd double %18, %25
  %27 = add nuw nsw i64 %17, 1
  %28 = add i64 %19, 1
  %29 = icmp eq i64 %28, %6
  br i1 %29, label %30, label %16

30:
  %31 = phi double [ 0.000000e+00, %3 ], [ %66, %10 ], [ %26, %16 ]
  ret double %31

32:
  %33 = phi i64 [ 0, %8 ], [ %67, %32 ]
  %34 = phi double [ 0.000000e+00, %8 ], [ %66, %32 ]
  %35 = phi i64 [ 0, %8 ], [ %68, %32 ]
  %36 = getelementptr inbounds double, ptr %1, i64 %33
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds double, ptr %0, i64 %33
  %39 = load double, ptr %38, align 8
  %40 = fmul double %37, %39
  %41 = fmul double %39, %40
  %42 = fadd double %34, %41
  %43 = or i64 %33, 1
  %44 = getelementptr inbounds double, ptr %1, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %0, i64 %43
  %47 = load double, ptr %46, align 8
  %48 = fmul double %45, %47
  %49 = fmul double %47, %48
  %50 = fadd double %42, %49
  %51 = or i64 %33, 2
  %52 = getelementptr inbounds double, ptr %1, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = getelementptr inbounds double, ptr %0, i64 %51
  %55 = load double, ptr %54, align 8
  %56 = fmul double %53, %55
  %57 = fmul double %55, %56
  %58 = fadd double %50, %57
  %59 = or i64 %33, 3
  %60 = getelementptr inbounds double, ptr %1, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = getelementptr inbounds double, ptr %0, i64 %59
  %63 = load double, ptr %62, align 8
  %64 = fmul double %61, %63
  %65 = fmul double %63, %64
  %66 = fadd double %58, %65
  %67 = add nuw nsw i64 %33, 4
  %68 = add i64 %35, 4
  %69 = icmp eq i64 %68, %9
  br i1 %69, label %10, label %32
}

define internal fastcc i32 @in_gap(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 120
  %3 = load ptr, ptr %2, align 8
  %4 = tail call fastcc i64 @address(ptr %3) #17
  %5 = tail call fastcc i64 @request(ptr %0, i64 2, i64 %4) #17
  %6 = icmp eq i64 %5, 1
  br i1 %6, label %7, label %26

7:
  %8 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
  %9 = icmp sgt i64 %8, 0
  br i1 %9, label %10, label %26

10:
  %11 = load ptr, ptr %2, align 8
  br label %15

12:
  %13 = add nuw nsw i64 %16, 1
  %14 = icmp eq i64 %13, %8
  br i1 %14, label %26, label %15

15:
  %16 = phi i64 [ 0, %10 ], [ %13, %12 ]
  %17 = getelementptr inbounds i32, ptr @pp_gaps, i64 %16
  %18 = load i32, ptr %17, align 4
  %19 = zext i32 %18 to i64
  %20 = getelementptr inbounds double, ptr %11, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = tail call fastcc double @size_of(double %21) #17
  %23 = getelementptr inbounds double, ptr @pp_depths, i64 %16
  %24 = load double, ptr %23, align 8
  %25 = fcmp ogt double %22, %24
  br i1 %25, label %26, label %12

26:
  %27 = phi i32 [ 1, %1 ], [ 0, %7 ], [ 0, %12 ], [ 1, %15 ]
  ret i32 %27
}

define internal fastcc i64 @request(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = getelementptr inbounds i8, ptr %0, i64 88
  %5 = load i64, ptr %4, align 8
  %6 = icmp eq i64 %5, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @follow_inputs(ptr %0) #17
  br label %8

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 136
  %10 = load ptr, ptr %9, align 8
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %12 = getelementptr inbounds i8, ptr %10, i64 %11
  %13 = tail call fastcc double @now(ptr %0) #17
  store double %13, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %12, i64 32
  store i64 0, ptr %14, align 8
  %15 = getelementptr inbounds i8, ptr %12, i64 16
  store <2 x double> zeroinitializer, ptr %15, align 8
  %16 = icmp eq i64 %1, 4
  %17 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 416), align 8
  %18 = select i1 %16, double %17, double 0.000000e+00
  %19 = getelementptr inbounds i8, ptr %12, i64 8
  store double %18, ptr %19, align 8
  %20 = load ptr, ptr getelementptr inbounds (i8, ptr @pp_entries, i64 8), align 8
  %21 = tail call fastcc i64 @address(ptr %12) #17
  %22 = tail call i64 %20(i64 %21, i64 %1, i64 %2) #19
  ret i64 %22
}

define internal fastcc void @follow_inputs(ptr %0) unnamed_addr #9 {
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %3 = icmp ne i64 %2, 0
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %5 = icmp sgt i64 %4, 0
  %6 = select i1 %3, i1 %5, i1 false
  br i1 %6, label %7, label %9

7:
  %8 = getelementptr inbounds i8, ptr %0, i64 112
  br label %10

9:
  ret void

10:
  %11 = phi i64 [ 0, %7 ], [ %28, %27 ]
  %12 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %11
  %13 = load i64, ptr %12, align 8
  %14 = add i64 %13, -9
  %15 = icmp ult i64 %14, -2
  br i1 %15, label %27, label %16

16:
  %17 = tail call fastcc ptr @drive_of(ptr %0, i64 %11) #17
  %18 = getelementptr inbounds i8, ptr %17, i64 48
  store i64 4, ptr %18, align 8
  %19 = tail call fastcc double @now(ptr %0) #17
  %20 = getelementptr inbounds i8, ptr %17, i64 112
  store double %19, ptr %20, align 8
  %21 = load ptr, ptr %8, align 8
  %22 = getelementptr inbounds double, ptr %21, i64 %11
  %23 = load double, ptr %22, align 8
  %24 = icmp eq i64 %13, 7
  %25 = select i1 %24, i64 104, i64 120
  %26 = getelementptr inbounds i8, ptr %17, i64 %25
  store double %23, ptr %26, align 8
  br label %27

27:
  %28 = add nuw nsw i64 %11, 1
  %29 = icmp slt i64 %28, %4
  br i1 %29, label %10, label %9
}

define internal fastcc i64 @restart(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i64 @request(ptr %0, i64 4, i64 0) #17
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 376), align 8
  %4 = icmp eq i64 %3, 0
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @rescale(ptr %0, double 0.000000e+00) #17
  br label %11

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 208), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 352), align 8
  %10 = getelementptr inbounds double, ptr %8, i64 %9
  store double 0x7FF8000000000000, ptr %10, align 8
  br label %11

11:
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 216), align 8
  %13 = tail call fastcc ptr @integers(ptr %0, i64 %12) #17
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 368), align 8
  %15 = getelementptr inbounds i64, ptr %13, i64 %14
  store i64 0, ptr %15, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 1, ptr %16, align 8
  ret i64 %2
}

define internal fastcc void @stop(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 1, ptr %5, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 144
  store i8 0, ptr %6, align 8
  tail call fastcc void @append(ptr %0, ptr %1) #17
  %7 = icmp sgt i64 %2, -1
  %8 = load i64, ptr @pp_n_sentences, align 8
  %9 = icmp slt i64 %2, %8
  %10 = select i1 %7, i1 %9, i1 false
  br i1 %10, label %11, label %14

11:
  tail call fastcc void @append(ptr %0, ptr @.str.48) #17
  %12 = getelementptr inbounds ptr, ptr @pp_sentences, i64 %2
  %13 = load ptr, ptr %12, align 8
  tail call fastcc void @append(ptr %0, ptr %13) #17
  br label %14

14:
  tail call fastcc void @append(ptr %0, ptr @.str.49) #17
  tail call fastcc void @append(ptr %0, ptr %3) #17
  tail call fastcc void @fail(ptr %0, ptr %6) #17
  ret void
}

define internal fastcc void @rescale(ptr %0, double %1) unnamed_addr #9 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  %4 = tail call fastcc ptr @reals(ptr %0, i64 %3) #17
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 224), align 8
  %6 = tail call fastcc ptr @reals(ptr %0, i64 %5) #17
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 232), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 136), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 240), align 8
  %12 = tail call fastcc ptr @reals(ptr %0, i64 %11) #17
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %23, label %15

15:
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 328), align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %52

18:
  %19 = and i64 %16, 1
  %20 = icmp eq i64 %16, 1
  br i1 %20, label %42, label %21

21:
  %22 = and i64 %16, 9223372036854775806
  br label %57

23:
  %24 = phi i64 [ %38, %23 ], [ 0, %2 ]
  %25 = getelementptr inbounds double, ptr %4, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %6, i64 %24
  %28 = load double, ptr %27, align 8
  %29 = fsub double %28, %26
  %30 = fmul double %1, %29
  %31 = fadd double %26, %30
  store double %31, ptr %27, align 8
  %32 = load double, ptr %25, align 8
  %33 = getelementptr inbounds double, ptr %8, i64 %24
  %34 = load double, ptr %33, align 8
  %35 = fsub double %34, %32
  %36 = fmul double %1, %35
  %37 = fadd double %32, %36
  store double %37, ptr %33, align 8
  %38 = add nuw nsw i64 %24, 1
  %39 = icmp eq i64 %38, %13
  br i1 %39, label %15, label %23

40:
  %41 = icmp eq i64 %19, 0
  br i1 %41, label %52, label %42

42:
  %43 = phi i64 [ 0, %18 ], [ %75, %40 ]
  %44 = icmp ne i64 %19, 0
  tail call void @llvm.assume(i1 %44)
  %45 = getelementptr inbounds double, ptr %10, i64 %43
  %46 = load double, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %12, i64 %43
  %48 = load double, ptr %47, align 8
  %49 = fsub double %48, %46
  %50 = fmul double %1, %49
  %51 = fadd double %46, %50
  store double %51, ptr %47, align 8
  br label %52

52:
  %53 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 216), align 8
  %54 = tail call fastcc ptr @integers(ptr %0, i64 %53) #17
  %55 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 368), align 8
  %56 = getelementptr inbounds i64, ptr %54, i64 %55
  store i64 0, ptr %56, align 8
  ret void

57:
  %58 = phi i64 [ 0, %21 ], [ %75, %57 ]
  %59 = phi i64 [ 0, %21 ], [ %76, %57 ]
  %60 = getelementptr inbounds double, ptr %10, i64 %58
  %61 = load double, ptr %60, align 8
  %62 = getelementptr inbounds double, ptr %12, i64 %58
  %63 = load double, ptr %62, align 8
  %64 = fsub double %63, %61
  %65 = fmul double %1, %64
  %66 = fadd double %61, %65
  store double %66, ptr %62, align 8
  %67 = or i64 %58, 1
  %68 = getelementptr inbounds double, ptr %10, i64 %67
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds double, ptr %12, i64 %67
  %71 = load double, ptr %70, align 8
  %72 = fsub double %71, %69
  %73 = fmul double %1, %72
  %74 = fadd double %69, %73
  store double %74, ptr %70, align 8
  %75 = add nuw nsw i64 %58, 2
  %76 = add i64 %59, 2
  %77 = icmp eq i64 %76, %22
  br i1 %77, label %40, label %57
}

define internal fastcc ptr @integers(ptr %0, i64 %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 136
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 %1
  ret ptr %5
}

define internal fastcc void @append(ptr %0, ptr %1) unnamed_addr #12 {
  %3 = getelementptr inbounds i8, ptr %0, i64 144
  br label %4

4:
  %5 = phi i64 [ 0, %2 ], [ %9, %4 ]
  %6 = getelementptr inbounds i8, ptr %3, i64 %5
  %7 = load i8, ptr %6, align 1
  %8 = icmp eq i8 %7, 0
  %9 = add i64 %5, 1
  br i1 %8, label %10, label %4

10:
  %11 = load i8, ptr %1, align 1
  %12 = icmp ne i8 %11, 0
  %13 = icmp ult i64 %9, 480
  %14 = and i1 %12, %13
  br i1 %14, label %15, label %27

15:
  %16 = phi i64 [ %24, %15 ], [ %9, %10 ]
  %17 = phi i8 [ %22, %15 ], [ %11, %10 ]
  %18 = phi i64 [ %16, %15 ], [ %5, %10 ]
  %19 = phi ptr [ %21, %15 ], [ %1, %10 ]
  %20 = getelementptr inbounds i8, ptr %3, i64 %18
  store i8 %17, ptr %20, align 1
  %21 = getelementptr inbounds i8, ptr %19, i64 1
  %22 = load i8, ptr %21, align 1
  %23 = icmp ne i8 %22, 0
  %24 = add nuw nsw i64 %16, 1
  %25 = icmp ult i64 %16, 479
  %26 = select i1 %23, i1 %25, i1 false
  br i1 %26, label %15, label %27

27:
  %28 = phi i64 [ %5, %10 ], [ %16, %15 ]
  %29 = getelementptr inbounds i8, ptr %3, i64 %28
  store i8 0, ptr %29, align 1
  ret void
}

define internal fastcc void @relocate(ptr %0, ptr %1) unnamed_addr #1 {
  %3 = getelementptr inbounds i8, ptr %0, i64 136
  %4 = load ptr, ptr %3, align 8
  %5 = load i64, ptr @pp_numbers, align 8
  %6 = tail call ptr @memcpy(ptr %4, ptr %1, i64 %5) #19
  %7 = load ptr, ptr %3, align 8
  %8 = tail call fastcc i64 @address(ptr %7) #17
  tail call fastcc void @move(ptr %7, i64 %8) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 16), align 8
  %10 = icmp sgt i64 %9, 0
  br i1 %10, label %12, label %11

11:
  ret void

12:
  %13 = phi i64 [ %25, %12 ], [ 0, %2 ]
  %14 = shl nuw nsw i64 %13, 3
  %15 = getelementptr inbounds i8, ptr @pp_code, i64 %14
  %16 = getelementptr inbounds i8, ptr %15, i64 4
  %17 = load i32, ptr %16, align 4
  %18 = zext i32 %17 to i64
  %19 = getelementptr inbounds ptr, ptr @pp_entries, i64 %18
  %20 = load ptr, ptr %19, align 8
  %21 = tail call fastcc i64 @address(ptr %20) #17
  %22 = load i32, ptr %15, align 4
  %23 = zext i32 %22 to i64
  %24 = tail call fastcc ptr @integers(ptr %0, i64 %23) #17
  store i64 %21, ptr %24, align 8
  %25 = add nuw nsw i64 %13, 1
  %26 = icmp eq i64 %25, %9
  br i1 %26, label %11, label %12
}

declare ptr @memcpy(ptr, ptr, i64) local_unnamed_addr #7

define internal fastcc void @move(ptr %0, i64 %1) unnamed_addr #12 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 8), align 8
  %4 = icmp sgt i64 %3, 0
  br i1 %4, label %5, label %27

5:
  %6 = and i64 %3, 3
  %7 = icmp ult i64 %3, 4
  br i1 %7, label %12, label %8

8:
  %9 = and i64 %3, 9223372036854775804
  br label %28

10:
  %11 = icmp eq i64 %6, 0
  br i1 %11, label %27, label %12

12:
  %13 = phi i64 [ 0, %5 ], [ %58, %10 ]
  %14 = icmp ne i64 %6, 0
  tail call void @llvm.assume(i1 %14)
  br label %15

15:
  %16 = phi i64 [ %24, %15 ], [ %13, %12 ]
  %17 = phi i64 [ %25, %15 ], [ 0, %12 ]
  %18 = getelementptr inbounds i32, ptr @pp_moved, i64 %16
  %19 = load i32, ptr %18, align 4
  %20 = zext i32 %19 to i64
  %21 = getelementptr inbounds i8, ptr %0, i64 %20
  %22 = load i64, ptr %21, align 8
  %23 = add nsw i64 %22, %1
  store i64 %23, ptr %21, align 8
  %24 = add nuw nsw i64 %16, 1
  %25 = add i64 %17, 1
  %26 = icmp eq i64 %25, %6
  br i1 %26, label %27, label %15

27:
  ret void

28:
  %29 = phi i64 [ 0, %8 ], [ %58, %28 ]
  %30 = phi i64 [ 0, %8 ], [ %59, %28 ]
  %31 = getelementptr inbounds i32, ptr @pp_moved, i64 %29
  %32 = load i32, ptr %31, align 4
  %33 = zext i32 %32 to i64
  %34 = getelementptr inbounds i8, ptr %0, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = add nsw i64 %35, %1
  store i64 %36, ptr %34, align 8
  %37 = getelementptr inbounds i32, ptr @pp_moved, i64 %29
  %38 = getelementptr inbounds i8, ptr %37, i64 4
  %39 = load i32, ptr %38, align 4
  %40 = zext i32 %39 to i64
  %41 = getelementptr inbounds i8, ptr %0, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = add nsw i64 %42, %1
  store i64 %43, ptr %41, align 8
  %44 = getelementptr inbounds i32, ptr @pp_moved, i64 %29
  %45 = getelementptr inbounds i8, ptr %44, i64 8
  %46 = load i32, ptr %45, align 4
  %47 = zext i32 %46 to i64
  %48 = getelementptr inbounds i8, ptr %0, i64 %47
  %49 = load i64, ptr %48, align 8
  %50 = add nsw i64 %49, %1
  store i64 %50, ptr %48, align 8
  %51 = getelementptr inbounds i32, ptr @pp_moved, i64 %29
  %52 = getelementptr inbounds i8, ptr %51, i64 12
  %53 = load i32, ptr %52, align 4
  %54 = zext i32 %53 to i64
  %55 = getelementptr inbounds i8, ptr %0, i64 %54
  %56 = load i64, ptr %55, align 8
  %57 = add nsw i64 %56, %1
  store i64 %57, ptr %55, align 8
  %58 = add nuw nsw i64 %29, 4
  %59 = add i64 %30, 4
  %60 = icmp eq i64 %59, %9
  br i1 %60, label %10, label %28
}

define internal fastcc ptr @state_at(ptr %0, i64 %1) unnamed_addr #4 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %4 = icmp slt i64 %1, %3
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %7 = select i1 %4, i64 %5, i64 %6
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = select i1 %4, i64 0, i64 %3
  %10 = sub nsw i64 %1, %9
  %11 = getelementptr inbounds double, ptr %8, i64 %10
  ret ptr %11
}

define internal fastcc void @fail_with(ptr %0, ptr %1, double %2, ptr %3, double %4, ptr %5) unnamed_addr #1 {
  %7 = getelementptr inbounds i8, ptr %0, i64 144
  store i8 0, ptr %7, align 8
  tail call fastcc void @append(ptr %0, ptr %1) #17
  tail call fastcc void @append_number(ptr %0, double %2) #17
  tail call fastcc void @append(ptr %0, ptr %3) #17
  tail call fastcc void @append_number(ptr %0, double %4) #17
  tail call fastcc void @append(ptr %0, ptr %5) #17
  tail call fastcc void @fail(ptr %0, ptr %7) #17
  ret void
}

define internal fastcc void @append_number(ptr %0, double %1) unnamed_addr #12 {
  %3 = alloca [24 x i8], align 16
  %4 = alloca [8 x i8], align 1
  %5 = tail call fastcc i32 @finite_number(double %1) #17
  %6 = icmp eq i32 %5, 0
  br i1 %6, label %7, label %8

7:
  tail call fastcc void @append(ptr %0, ptr @.str.60) #17
  br label %202

8:
  %9 = fcmp olt double %1, 0.000000e+00
  br i1 %9, label %10, label %12

10:
  store i8 45, ptr %3, align 16
  %11 = fneg double %1
  br label %12

12:
  %13 = phi i32 [ 1, %10 ], [ 0, %8 ]
  %14 = phi double [ %11, %10 ], [ %1, %8 ]
  %15 = fcmp ult double %14, 1.000000e+01
  br i1 %15, label %16, label %22

16:
  %17 = phi i32 [ 0, %12 ], [ %26, %22 ]
  %18 = phi double [ %14, %12 ], [ %25, %22 ]
  %19 = fcmp ogt double %18, 0.000000e+00
  %20 = fcmp olt double %18, 1.000000e+00
  %21 = and i1 %19, %20
  br i1 %21, label %28, label %36

22:
  %23 = phi double [ %25, %22 ], [ %14, %12 ]
  %24 = phi i32 [ %26, %22 ], [ 0, %12 ]
  %25 = fdiv double %23, 1.000000e+01
  %26 = add nuw nsw i32 %24, 1
  %27 = fcmp ult double %25, 1.000000e+01
  br i1 %27, label %16, label %22

28:
  %29 = phi double [ %31, %28 ], [ %18, %16 ]
  %30 = phi i32 [ %32, %28 ], [ %17, %16 ]
  %31 = fmul double %29, 1.000000e+01
  %32 = add nsw i32 %30, -1
  %33 = fcmp ogt double %31, 0.000000e+00
  %34 = fcmp olt double %31, 1.000000e+00
  %35 = and i1 %33, %34
  br i1 %35, label %28, label %36

36:
  %37 = phi i32 [ %17, %16 ], [ %32, %28 ]
  %38 = phi double [ %18, %16 ], [ %31, %28 ]
  %39 = fmul double %38, 1.000000e+05
  %40 = fadd double %39, 5.000000e-01
  %41 = fptosi double %40 to i64
  %42 = icmp sgt i64 %41, 999999
  br i1 %42, label %43, label %46

43:
  %44 = udiv i64 %41, 10
  %45 = add nsw i32 %37, 1
  br label %46

46:
  %47 = phi i32 [ %45, %43 ], [ %37, %36 ]
  %48 = phi i64 [ %44, %43 ], [ %41, %36 ]
  %49 = srem i64 %48, 10
  %50 = sdiv i64 %48, 10
  %51 = icmp eq i64 %49, 0
  br i1 %51, label %53, label %52

52:
  br label %73

53:
  %54 = srem i64 %50, 10
  %55 = icmp eq i64 %54, 0
  br i1 %55, label %56, label %70

56:
  %57 = sdiv i64 %48, 100
  %58 = srem i64 %57, 10
  %59 = icmp eq i64 %58, 0
  br i1 %59, label %60, label %70

60:
  %61 = sdiv i64 %48, 1000
  %62 = srem i64 %61, 10
  %63 = icmp eq i64 %62, 0
  br i1 %63, label %64, label %70

64:
  %65 = sdiv i64 %48, 10000
  %66 = srem i64 %65, 10
  %67 = icmp eq i64 %66, 0
  br i1 %67, label %68, label %70

68:
  %69 = sdiv i64 %48, 100000
  br label %70

70:
  %71 = phi i64 [ %50, %53 ], [ %57, %56 ], [ %61, %60 ], [ %65, %64 ], [ %69, %68 ]
  %72 = phi i32 [ 5, %53 ], [ 4, %56 ], [ 3, %60 ], [ 2, %64 ], [ 1, %68 ]
  br label %73

73:
  %74 = phi i64 [ %48, %52 ], [ %71, %70 ]
  %75 = phi i32 [ 6, %52 ], [ %72, %70 ]
  %76 = zext i32 %75 to i64
  %77 = srem i64 %74, 10
  %78 = sdiv i64 %74, 10
  %79 = trunc i64 %77 to i8
  %80 = add nsw i8 %79, 48
  %81 = getelementptr i8, ptr %4, i64 %76
  %82 = getelementptr i8, ptr %81, i64 -1
  store i8 %80, ptr %82, align 1
  %83 = icmp ugt i32 %75, 1
  br i1 %83, label %91, label %84

84:
  %85 = add i32 %47, -6
  %86 = icmp ult i32 %85, -9
  %87 = select i1 %86, i32 %47, i32 0
  %88 = sub nsw i32 %47, %87
  %89 = tail call i32 @llvm.smin.i32(i32 %88, i32 0)
  %90 = icmp slt i32 %89, %75
  br label %131

91:
  %92 = srem i64 %78, 10
  %93 = trunc i64 %92 to i8
  %94 = add nsw i8 %93, 48
  %95 = getelementptr i8, ptr %4, i64 %76
  %96 = getelementptr i8, ptr %95, i64 -2
  store i8 %94, ptr %96, align 1
  %97 = icmp eq i32 %75, 2
  br i1 %97, label %84, label %98

98:
  %99 = sdiv i64 %74, 100
  %100 = srem i64 %99, 10
  %101 = trunc i64 %100 to i8
  %102 = add nsw i8 %101, 48
  %103 = getelementptr i8, ptr %4, i64 %76
  %104 = getelementptr i8, ptr %103, i64 -3
  store i8 %102, ptr %104, align 1
  %105 = icmp ugt i32 %75, 3
  br i1 %105, label %106, label %84

106:
  %107 = sdiv i64 %74, 1000
  %108 = srem i64 %107, 10
  %109 = trunc i64 %108 to i8
  %110 = add nsw i8 %109, 48
  %111 = getelementptr i8, ptr %4, i64 %76
  %112 = getelementptr i8, ptr %111, i64 -4
  store i8 %110, ptr %112, align 1
  %113 = icmp eq i32 %75, 4
  br i1 %113, label %84, label %114

114:
  %115 = sdiv i64 %74, 10000
  %116 = srem i64 %115, 10
  %117 = trunc i64 %116 to i8
  %118 = add nsw i8 %117, 48
  %119 = getelementptr i8, ptr %4, i64 %76
  %120 = getelementptr i8, ptr %119, i64 -5
  store i8 %118, ptr %120, align 1
  %121 = icmp ugt i32 %75, 5
  br i1 %121, label %122, label %84

122:
  %123 = sdiv i64 %74, 100000
  %124 = srem i64 %123, 10
  %125 = trunc i64 %124 to i8
  %126 = add nsw i8 %125, 48
  %127 = getelementptr i8, ptr %4, i64 %76
  %128 = getelementptr i8, ptr %127, i64 -6
  store i8 %126, ptr %128, align 1
  br label %84

129:
  %130 = icmp eq i32 %87, 0
  br i1 %130, label %198, label %158

131:
  %132 = phi i1 [ %90, %84 ], [ %148, %154 ]
  %133 = phi i32 [ %89, %84 ], [ %147, %154 ]
  %134 = phi i32 [ %13, %84 ], [ %155, %154 ]
  %135 = icmp sgt i32 %133, -1
  %136 = and i1 %135, %132
  br i1 %136, label %137, label %141

137:
  %138 = zext i32 %133 to i64
  %139 = getelementptr inbounds i8, ptr %4, i64 %138
  %140 = load i8, ptr %139, align 1
  br label %141

141:
  %142 = phi i8 [ %140, %137 ], [ 48, %131 ]
  %143 = add nsw i32 %134, 1
  %144 = sext i32 %134 to i64
  %145 = getelementptr inbounds i8, ptr %3, i64 %144
  store i8 %142, ptr %145, align 1
  %146 = icmp eq i32 %133, %88
  %147 = add nsw i32 %133, 1
  %148 = icmp slt i32 %147, %75
  %149 = select i1 %146, i1 %148, i1 false
  br i1 %149, label %150, label %154

150:
  %151 = add nsw i32 %134, 2
  %152 = sext i32 %143 to i64
  %153 = getelementptr inbounds i8, ptr %3, i64 %152
  store i8 46, ptr %153, align 1
  br label %154

154:
  %155 = phi i32 [ %151, %150 ], [ %143, %141 ]
  %156 = icmp slt i32 %133, %88
  %157 = select i1 %148, i1 true, i1 %156
  br i1 %157, label %131, label %129

158:
  %159 = add nsw i32 %155, 1
  %160 = sext i32 %155 to i64
  %161 = getelementptr inbounds i8, ptr %3, i64 %160
  store i8 101, ptr %161, align 1
  %162 = icmp slt i32 %87, 0
  br i1 %162, label %163, label %168

163:
  %164 = add nsw i32 %155, 2
  %165 = sext i32 %159 to i64
  %166 = getelementptr inbounds i8, ptr %3, i64 %165
  store i8 45, ptr %166, align 1
  %167 = sub nsw i32 0, %87
  br label %168

168:
  %169 = phi i32 [ %164, %163 ], [ %159, %158 ]
  %170 = phi i32 [ %167, %163 ], [ %47, %158 ]
  %171 = icmp ugt i32 %170, 99
  br i1 %171, label %172, label %179

172:
  %173 = udiv i32 %170, 100
  %174 = trunc i32 %173 to i8
  %175 = add i8 %174, 48
  %176 = add nsw i32 %169, 1
  %177 = sext i32 %169 to i64
  %178 = getelementptr inbounds i8, ptr %3, i64 %177
  store i8 %175, ptr %178, align 1
  br label %181

179:
  %180 = icmp ugt i32 %170, 9
  br i1 %180, label %181, label %190

181:
  %182 = phi i32 [ %176, %172 ], [ %169, %179 ]
  %183 = udiv i32 %170, 10
  %184 = urem i32 %183, 10
  %185 = trunc i32 %184 to i8
  %186 = or i8 %185, 48
  %187 = add nsw i32 %182, 1
  %188 = sext i32 %182 to i64
  %189 = getelementptr inbounds i8, ptr %3, i64 %188
  store i8 %186, ptr %189, align 1
  br label %190

190:
  %191 = phi i32 [ %187, %181 ], [ %169, %179 ]
  %192 = urem i32 %170, 10
  %193 = trunc i32 %192 to i8
  %194 = or i8 %193, 48
  %195 = add nsw i32 %191, 1
  %196 = sext i32 %191 to i64
  %197 = getelementptr inbounds i8, ptr %3, i64 %196
  store i8 %194, ptr %197, align 1
  br label %198

198:
  %199 = phi i32 [ %195, %190 ], [ %155, %129 ]
  %200 = sext i32 %199 to i64
  %201 = getelementptr inbounds i8, ptr %3, i64 %200
  store i8 0, ptr %201, align 1
  call fastcc void @append(ptr %0, ptr %3) #17
  br label %202

202:
  ret void
}

define internal fastcc i32 @is_own(ptr %0) unnamed_addr #6 {
  br label %2

2:
  %3 = phi i64 [ 0, %1 ], [ %21, %20 ]
  %4 = getelementptr inbounds i8, ptr @pp_token, i64 %3
  %5 = load i8, ptr %4, align 1
  %6 = icmp eq i8 %5, 0
  br i1 %6, label %23, label %7

7:
  %8 = getelementptr inbounds i8, ptr %0, i64 %3
  %9 = load i8, ptr %8, align 1
  %10 = icmp eq i8 %9, %5
  br i1 %10, label %11, label %23

11:
  %12 = or i64 %3, 1
  %13 = getelementptr inbounds i8, ptr @pp_token, i64 %12
  %14 = load i8, ptr %13, align 1
  %15 = icmp eq i8 %14, 0
  br i1 %15, label %23, label %16

16:
  %17 = getelementptr inbounds i8, ptr %0, i64 %12
  %18 = load i8, ptr %17, align 1
  %19 = icmp eq i8 %18, %14
  br i1 %19, label %20, label %23

20:
  %21 = add nuw nsw i64 %3, 2
  %22 = icmp eq i64 %21, 40
  br i1 %22, label %34, label %2

23:
  %24 = phi i64 [ %3, %7 ], [ %3, %2 ], [ %12, %11 ], [ %12, %16 ]
  %25 = and i64 %24, 4294967295
  %26 = getelementptr inbounds i8, ptr @pp_token, i64 %25
  %27 = load i8, ptr %26, align 1
  %28 = icmp eq i8 %27, 0
  br i1 %28, label %29, label %34

29:
  %30 = getelementptr inbounds i8, ptr %0, i64 %25
  %31 = load i8, ptr %30, align 1
  %32 = icmp eq i8 %31, 0
  %33 = zext i1 %32 to i32
  br label %34

34:
  %35 = phi i32 [ %33, %29 ], [ 0, %23 ], [ 1, %20 ]
  ret i32 %35
}

define internal fastcc double @change_of(ptr %0, i32 %1, double %2) unnamed_addr #13 {
  %4 = zext i32 %1 to i64
  %5 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %4
  %6 = load i64, ptr %5, align 8
  %7 = icmp eq i64 %6, 3
  br i1 %7, label %8, label %14

8:
  %9 = getelementptr inbounds i8, ptr %5, i64 8
  %10 = load i64, ptr %9, align 8
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %12 = icmp slt i64 %10, %11
  %13 = select i1 %12, double 1.000000e-08, double 1.000000e-04
  br label %32

14:
  %15 = getelementptr inbounds i8, ptr %0, i64 112
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %16, i64 %4
  %18 = load double, ptr %17, align 8
  %19 = fcmp olt double %18, 0.000000e+00
  %20 = fneg double %18
  %21 = select i1 %19, double %20, double %18
  %22 = fadd double %21, 1.000000e+00
  %23 = fmul double %22, 0x3EB0C6F7A0B5ED8D
  %24 = getelementptr inbounds i8, ptr %5, i64 40
  %25 = load double, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %5, i64 32
  %27 = load double, ptr %26, align 8
  %28 = fsub double %25, %27
  %29 = fmul double %28, 2.500000e-01
  %30 = fcmp olt double %29, %23
  %31 = select i1 %30, double %29, double %23
  br label %32

32:
  %33 = phi double [ %13, %8 ], [ %31, %14 ]
  %34 = fcmp olt double %2, 0.000000e+00
  %35 = fneg double %2
  %36 = select i1 %34, double %35, double %2
  %37 = fdiv double %33, %36
  ret double %37
}

define internal fastcc double @room_of(ptr %0, i32 %1, double %2) unnamed_addr #13 {
  %4 = zext i32 %1 to i64
  %5 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %4
  %6 = load i64, ptr %5, align 8
  %7 = icmp eq i64 %6, 3
  %8 = fcmp oeq double %2, 0.000000e+00
  %9 = or i1 %8, %7
  br i1 %9, label %31, label %10

10:
  %11 = fcmp ogt double %2, 0.000000e+00
  br i1 %11, label %12, label %21

12:
  %13 = getelementptr inbounds i8, ptr %5, i64 40
  %14 = load double, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %0, i64 112
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %16, i64 %4
  %18 = load double, ptr %17, align 8
  %19 = fsub double %14, %18
  %20 = fdiv double %19, %2
  br label %31

21:
  %22 = getelementptr inbounds i8, ptr %0, i64 112
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds double, ptr %23, i64 %4
  %25 = load double, ptr %24, align 8
  %26 = getelementptr inbounds i8, ptr %5, i64 32
  %27 = load double, ptr %26, align 8
  %28 = fsub double %25, %27
  %29 = fneg double %2
  %30 = fdiv double %28, %29
  br label %31

31:
  %32 = phi double [ 1.000000e+300, %3 ], [ %20, %12 ], [ %30, %21 ]
  ret double %32
}

define internal fastcc i32 @add(ptr %0, ptr %1, i64 %2, ptr %3, double %4) unnamed_addr #1 {
  %6 = alloca double, align 8
  %7 = icmp eq i64 %2, 0
  br i1 %7, label %49, label %8

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 112
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  br label %11

11:
  %12 = phi i64 [ 0, %8 ], [ %47, %46 ]
  %13 = getelementptr inbounds i32, ptr %1, i64 %12
  %14 = load i32, ptr %13, align 4
  %15 = zext i32 %14 to i64
  %16 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %15
  %17 = getelementptr inbounds double, ptr %3, i64 %12
  %18 = load double, ptr %17, align 8
  %19 = fmul double %4, %18
  %20 = load i64, ptr %16, align 8
  %21 = icmp eq i64 %20, 3
  br i1 %21, label %22, label %28

22:
  %23 = getelementptr inbounds i8, ptr %16, i64 8
  %24 = load i64, ptr %23, align 8
  %25 = tail call fastcc ptr @state_at(ptr %0, i64 %24) #17
  %26 = load double, ptr %25, align 8
  %27 = fadd double %19, %26
  store double %27, ptr %25, align 8
  store i64 2, ptr %10, align 8
  br label %46

28:
  %29 = load ptr, ptr %9, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %15
  %31 = load double, ptr %30, align 8
  %32 = fadd double %19, %31
  store double %32, ptr %6, align 8
  %33 = getelementptr inbounds i8, ptr %16, i64 40
  %34 = load double, ptr %33, align 8
  %35 = fcmp ogt double %32, %34
  br i1 %35, label %36, label %37

36:
  store double %34, ptr %6, align 8
  br label %37

37:
  %38 = phi double [ %34, %36 ], [ %32, %28 ]
  %39 = getelementptr inbounds i8, ptr %16, i64 32
  %40 = load double, ptr %39, align 8
  %41 = fcmp olt double %38, %40
  br i1 %41, label %42, label %43

42:
  store double %40, ptr %6, align 8
  br label %43

43:
  %44 = call fastcc i32 @set_numbers(ptr %0, ptr %13, i64 1, ptr %6) #17
  %45 = icmp eq i32 %44, 0
  br i1 %45, label %46, label %49

46:
  %47 = add nuw i64 %12, 1
  %48 = icmp eq i64 %47, %2
  br i1 %48, label %49, label %11

49:
  %50 = phi i32 [ 0, %5 ], [ 0, %46 ], [ 3, %43 ]
  ret i32 %50
}

define internal fastcc i64 @change_step(ptr %0, double %1) unnamed_addr #1 {
  %3 = tail call fastcc double @now(ptr %0) #17
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 376), align 8
  %5 = icmp ne i64 %4, 0
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 328), align 8
  %7 = icmp ne i64 %6, 0
  %8 = select i1 %5, i1 %7, i1 false
  br i1 %8, label %9, label %10

9:
  tail call fastcc void @tolerate(ptr %0, double %1) #17
  br label %10

10:
  %11 = icmp eq i64 %4, 0
  %12 = icmp eq i64 %6, 0
  %13 = select i1 %11, i1 true, i1 %12
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 264), align 8
  %15 = icmp ne i64 %14, 0
  %16 = select i1 %13, i1 true, i1 %15
  br i1 %16, label %26, label %17

17:
  %18 = getelementptr inbounds i8, ptr %0, i64 72
  %19 = load i64, ptr %18, align 8
  %20 = icmp eq i64 %19, 2
  br i1 %20, label %27, label %21

21:
  %22 = getelementptr inbounds i8, ptr %0, i64 56
  %23 = load double, ptr %22, align 8
  %24 = fdiv double %1, %23
  %25 = tail call fastcc i64 @shift_rates(ptr %0, double %24) #17
  br label %27

26:
  br i1 %11, label %32, label %27

27:
  %28 = phi i64 [ 1, %26 ], [ 1, %17 ], [ %25, %21 ]
  %29 = getelementptr inbounds i8, ptr %0, i64 56
  %30 = load double, ptr %29, align 8
  %31 = fdiv double %1, %30
  tail call fastcc void @rescale(ptr %0, double %31) #17
  br label %37

32:
  %33 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 208), align 8
  %34 = tail call fastcc ptr @reals(ptr %0, i64 %33) #17
  %35 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 360), align 8
  %36 = getelementptr inbounds double, ptr %34, i64 %35
  store double 0.000000e+00, ptr %36, align 8
  br label %37

37:
  %38 = phi i64 [ 1, %32 ], [ %28, %27 ]
  %39 = getelementptr inbounds i8, ptr %0, i64 48
  store double %3, ptr %39, align 8
  %40 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %40, align 8
  %41 = getelementptr inbounds i8, ptr %0, i64 56
  store double %1, ptr %41, align 8
  ret i64 %38
}

define internal fastcc void @lead(ptr %0, double %1) unnamed_addr #9 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %4 = icmp ne i64 %3, 0
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %6 = icmp sgt i64 %5, 0
  %7 = select i1 %4, i1 %6, i1 false
  br i1 %7, label %8, label %11

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 112
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  br label %12

11:
  ret void

12:
  %13 = phi i64 [ 0, %8 ], [ %70, %69 ]
  %14 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %13
  %15 = load i64, ptr %14, align 8
  %16 = icmp eq i64 %15, 7
  br i1 %16, label %17, label %69

17:
  %18 = tail call fastcc ptr @drive_of(ptr %0, i64 %13) #17
  %19 = getelementptr inbounds i8, ptr %18, i64 48
  %20 = load i64, ptr %19, align 8
  %21 = icmp eq i64 %20, 3
  br i1 %21, label %22, label %29

22:
  %23 = getelementptr inbounds i8, ptr %18, i64 120
  %24 = load double, ptr %23, align 8
  %25 = tail call fastcc double @now(ptr %0) #17
  %26 = getelementptr inbounds i8, ptr %18, i64 112
  %27 = load double, ptr %26, align 8
  %28 = fsub double %25, %27
  br label %31

29:
  %30 = tail call fastcc double @now(ptr %0) #17
  br label %31

31:
  %32 = phi double [ %24, %22 ], [ 0.000000e+00, %29 ]
  %33 = phi double [ %28, %22 ], [ %30, %29 ]
  %34 = getelementptr inbounds i8, ptr %18, i64 104
  %35 = load double, ptr %34, align 8
  %36 = fmul double %32, %33
  %37 = fadd double %35, %36
  %38 = load ptr, ptr %9, align 8
  %39 = getelementptr inbounds double, ptr %38, i64 %13
  %40 = load double, ptr %39, align 8
  %41 = fsub double %40, %37
  %42 = insertelement <2 x double> poison, double %37, i64 0
  %43 = insertelement <2 x double> %42, double %40, i64 1
  %44 = fcmp olt <2 x double> %43, zeroinitializer
  %45 = fneg <2 x double> %43
  %46 = select <2 x i1> %44, <2 x double> %45, <2 x double> %43
  %47 = shufflevector <2 x double> %46, <2 x double> poison, <2 x i32> <i32 1, i32 poison>
  %48 = fadd <2 x double> %46, %47
  %49 = extractelement <2 x double> %48, i64 0
  %50 = fmul double %49, 0x3D06849B86A12B9B
  %51 = fcmp ugt double %41, %50
  %52 = fneg double %41
  %53 = fcmp ult double %50, %52
  %54 = or i1 %51, %53
  %55 = select i1 %54, double %37, double %40
  %56 = fsub double %40, %55
  %57 = fdiv double %56, %1
  %58 = fcmp oeq double %57, 0.000000e+00
  %59 = fcmp oeq double %32, 0.000000e+00
  %60 = and i1 %59, %58
  br i1 %60, label %69, label %61

61:
  %62 = getelementptr inbounds i8, ptr %18, i64 96
  %63 = load double, ptr %62, align 8
  %64 = fmul double %32, 5.000000e-01
  %65 = fmul double %64, %33
  %66 = fadd double %35, %65
  %67 = fmul double %33, %66
  %68 = fadd double %67, %63
  tail call fastcc void @turn_on(ptr %0, ptr %18, double %68, double %55, double %57) #17
  store i64 2, ptr %10, align 8
  br label %69

69:
  %70 = add nuw nsw i64 %13, 1
  %71 = icmp slt i64 %70, %5
  br i1 %71, label %12, label %11
}

define internal fastcc i64 @advance(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = alloca [3 x i64], align 16
  %5 = alloca %struct.Recorder, align 8
  call void @llvm.memset.p0.i64(ptr align 16 dereferenceable(24) %4, i8 0, i64 24, i1 false)
  store i64 %2, ptr %5, align 8
  %6 = getelementptr inbounds i8, ptr %5, i64 8
  store i64 1, ptr %6, align 8
  %7 = getelementptr inbounds i8, ptr %5, i64 16
  %8 = getelementptr inbounds i8, ptr %0, i64 128
  %9 = load ptr, ptr %8, align 8
  %10 = tail call fastcc i64 @address(ptr %9) #17
  store i64 %10, ptr %7, align 8
  %11 = getelementptr inbounds i8, ptr %5, i64 24
  store i64 %2, ptr %11, align 8
  %12 = getelementptr inbounds i8, ptr %5, i64 32
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  %14 = add nsw i64 %13, 1
  store i64 %14, ptr %12, align 8
  %15 = getelementptr inbounds i8, ptr %5, i64 40
  store <6 x i64> zeroinitializer, ptr %15, align 8
  %16 = getelementptr inbounds i8, ptr %5, i64 88
  %17 = call fastcc i64 @address(ptr %4) #17
  store i64 %17, ptr %16, align 8
  %18 = getelementptr inbounds i8, ptr %5, i64 96
  store i64 0, ptr %18, align 8
  %19 = getelementptr inbounds i8, ptr %5, i64 104
  store i64 0, ptr %19, align 8
  %20 = getelementptr inbounds i8, ptr %0, i64 48
  %21 = load double, ptr %20, align 8
  %22 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 280), align 8
  %23 = call fastcc ptr @reals(ptr %0, i64 %22) #17
  store double %21, ptr %23, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 56
  %25 = load double, ptr %24, align 8
  %26 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 288), align 8
  %27 = call fastcc ptr @reals(ptr %0, i64 %26) #17
  store double %25, ptr %27, align 8
  %28 = getelementptr inbounds i8, ptr %0, i64 64
  %29 = load i64, ptr %28, align 8
  %30 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 304), align 8
  %31 = call fastcc ptr @integers(ptr %0, i64 %30) #17
  store i64 %29, ptr %31, align 8
  %32 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 312), align 8
  %33 = call fastcc ptr @integers(ptr %0, i64 %32) #17
  store i64 %1, ptr %33, align 8
  %34 = load ptr, ptr @pp_entries, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 136
  %36 = load ptr, ptr %35, align 8
  %37 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %38 = getelementptr inbounds i8, ptr %36, i64 %37
  %39 = call fastcc i64 @address(ptr %38) #17
  %40 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 272), align 8
  %41 = getelementptr inbounds i8, ptr %36, i64 %40
  %42 = call fastcc i64 @address(ptr %41) #17
  %43 = call fastcc i64 @address(ptr %5) #17
  %44 = call i64 %34(i64 %39, i64 %42, i64 %43) #19
  %45 = load i64, ptr %4, align 16
  %46 = load i64, ptr %28, align 8
  %47 = add nsw i64 %46, %45
  store i64 %47, ptr %28, align 8
  %48 = icmp eq i64 %44, 1
  %49 = icmp ne i64 %2, 0
  %50 = and i1 %49, %48
  br i1 %50, label %51, label %110

51:
  %52 = icmp sgt i64 %13, 0
  br i1 %52, label %53, label %75

53:
  %54 = getelementptr inbounds i8, ptr %0, i64 120
  %55 = and i64 %13, 3
  %56 = icmp ult i64 %13, 4
  br i1 %56, label %61, label %57

57:
  %58 = and i64 %13, 9223372036854775804
  br label %81

59:
  %60 = icmp eq i64 %55, 0
  br i1 %60, label %75, label %61

61:
  %62 = phi i64 [ 0, %53 ], [ %103, %59 ]
  %63 = icmp ne i64 %55, 0
  call void @llvm.assume(i1 %63)
  br label %64

64:
  %65 = phi i64 [ %62, %61 ], [ %68, %64 ]
  %66 = phi i64 [ 0, %61 ], [ %73, %64 ]
  %67 = load ptr, ptr %8, align 8
  %68 = add nuw nsw i64 %65, 1
  %69 = getelementptr inbounds double, ptr %67, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = load ptr, ptr %54, align 8
  %72 = getelementptr inbounds double, ptr %71, i64 %65
  store double %70, ptr %72, align 8
  %73 = add i64 %66, 1
  %74 = icmp eq i64 %73, %55
  br i1 %74, label %75, label %64

75:
  %76 = getelementptr inbounds i8, ptr %0, i64 120
  %77 = load ptr, ptr %76, align 8
  %78 = call fastcc i32 @all_finite(ptr %77, i64 %13) #17
  %79 = icmp eq i32 %78, 0
  %80 = select i1 %79, i64 4, i64 1
  br label %110

81:
  %82 = phi i64 [ 0, %57 ], [ %103, %81 ]
  %83 = phi i64 [ 0, %57 ], [ %108, %81 ]
  %84 = load ptr, ptr %8, align 8
  %85 = or i64 %82, 1
  %86 = getelementptr inbounds double, ptr %84, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = load ptr, ptr %54, align 8
  %89 = getelementptr inbounds double, ptr %88, i64 %82
  store double %87, ptr %89, align 8
  %90 = load ptr, ptr %8, align 8
  %91 = or i64 %82, 2
  %92 = getelementptr inbounds double, ptr %90, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = load ptr, ptr %54, align 8
  %95 = getelementptr inbounds double, ptr %94, i64 %85
  store double %93, ptr %95, align 8
  %96 = load ptr, ptr %8, align 8
  %97 = or i64 %82, 3
  %98 = getelementptr inbounds double, ptr %96, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = load ptr, ptr %54, align 8
  %101 = getelementptr inbounds double, ptr %100, i64 %91
  store double %99, ptr %101, align 8
  %102 = load ptr, ptr %8, align 8
  %103 = add nuw nsw i64 %82, 4
  %104 = getelementptr inbounds double, ptr %102, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = load ptr, ptr %54, align 8
  %107 = getelementptr inbounds double, ptr %106, i64 %97
  store double %105, ptr %107, align 8
  %108 = add i64 %83, 4
  %109 = icmp eq i64 %108, %58
  br i1 %109, label %59, label %81

110:
  %111 = phi i64 [ %80, %75 ], [ %44, %3 ]
  ret i64 %111
}

define internal fastcc void @tolerate(ptr %0, double %1) unnamed_addr #9 {
  %3 = fmul double %1, 2.500000e-01
  %4 = fmul double %1, %3
  %5 = fmul double %4, 2.000000e-03
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 264), align 8
  %7 = tail call fastcc ptr @reals(ptr %0, i64 %6) #17
  %8 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %9 = tail call fastcc ptr @reals(ptr %0, i64 %8) #17
  %10 = fcmp ogt double %5, 0x3DA5FD7FE1796495
  %11 = select i1 %10, double 0x3DA5FD7FE1796495, double %5
  %12 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 424), align 8
  %13 = fmul double %12, 4.000000e-15
  %14 = fcmp olt double %11, %13
  %15 = select i1 %14, double %13, double %11
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 296), align 8
  %17 = tail call fastcc ptr @reals(ptr %0, i64 %16) #17
  store double %15, ptr %17, align 8
  %18 = icmp ne i64 %6, 0
  %19 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %20 = icmp sgt i64 %19, 0
  %21 = select i1 %18, i1 %20, i1 false
  br i1 %21, label %22, label %40

22:
  %23 = and i64 %19, 1
  %24 = icmp eq i64 %19, 1
  br i1 %24, label %29, label %25

25:
  %26 = and i64 %19, 9223372036854775806
  br label %41

27:
  %28 = icmp eq i64 %23, 0
  br i1 %28, label %40, label %29

29:
  %30 = phi i64 [ 0, %22 ], [ %61, %27 ]
  %31 = icmp ne i64 %23, 0
  tail call void @llvm.assume(i1 %31)
  %32 = getelementptr inbounds double, ptr %9, i64 %30
  %33 = load double, ptr %32, align 8
  %34 = fmul double %33, 4.000000e-15
  %35 = fcmp ogt double %15, %34
  %36 = fdiv double %15, %33
  %37 = fdiv double 1.000000e+00, %36
  %38 = select i1 %35, double %37, double 0x42EC6BF52633FFFF
  %39 = getelementptr inbounds double, ptr %7, i64 %30
  store double %38, ptr %39, align 8
  br label %40

40:
  ret void

41:
  %42 = phi i64 [ 0, %25 ], [ %61, %41 ]
  %43 = phi i64 [ 0, %25 ], [ %62, %41 ]
  %44 = getelementptr inbounds double, ptr %9, i64 %42
  %45 = load double, ptr %44, align 8
  %46 = fmul double %45, 4.000000e-15
  %47 = fcmp ogt double %15, %46
  %48 = fdiv double %15, %45
  %49 = fdiv double 1.000000e+00, %48
  %50 = select i1 %47, double %49, double 0x42EC6BF52633FFFF
  %51 = getelementptr inbounds double, ptr %7, i64 %42
  store double %50, ptr %51, align 8
  %52 = or i64 %42, 1
  %53 = getelementptr inbounds double, ptr %9, i64 %52
  %54 = load double, ptr %53, align 8
  %55 = fmul double %54, 4.000000e-15
  %56 = fcmp ogt double %15, %55
  %57 = fdiv double %15, %54
  %58 = fdiv double 1.000000e+00, %57
  %59 = select i1 %56, double %58, double 0x42EC6BF52633FFFF
  %60 = getelementptr inbounds double, ptr %7, i64 %52
  store double %59, ptr %60, align 8
  %61 = add nuw nsw i64 %42, 2
  %62 = add i64 %43, 2
  %63 = icmp eq i64 %62, %26
  br i1 %63, label %27, label %41
}

define internal fastcc i64 @shift_rates(ptr %0, double %1) unnamed_addr #1 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 328), align 8
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 168), align 8
  %6 = tail call fastcc ptr @reals(ptr %0, i64 %5) #17
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 176), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 184), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 192), align 8
  %12 = tail call fastcc ptr @reals(ptr %0, i64 %11) #17
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %14 = tail call fastcc ptr @reals(ptr %0, i64 %13) #17
  %15 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  %16 = tail call fastcc ptr @reals(ptr %0, i64 %15) #17
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 136), align 8
  %18 = tail call fastcc ptr @reals(ptr %0, i64 %17) #17
  %19 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 152), align 8
  %20 = tail call fastcc ptr @reals(ptr %0, i64 %19) #17
  %21 = add nsw i64 %4, %3
  %22 = shl i64 %21, 3
  %23 = tail call fastcc ptr @allocate(ptr %0, i64 %22) #17
  %24 = icmp eq ptr %23, null
  br i1 %24, label %275, label %25

25:
  %26 = icmp slt i64 %3, 1
  br i1 %26, label %46, label %27

27:
  %28 = and i64 %3, 3
  %29 = icmp ult i64 %3, 4
  br i1 %29, label %34, label %30

30:
  %31 = and i64 %3, 9223372036854775804
  br label %54

32:
  %33 = icmp eq i64 %28, 0
  br i1 %33, label %46, label %34

34:
  %35 = phi i64 [ 0, %27 ], [ %72, %32 ]
  %36 = icmp ne i64 %28, 0
  tail call void @llvm.assume(i1 %36)
  br label %37

37:
  %38 = phi i64 [ %43, %37 ], [ %35, %34 ]
  %39 = phi i64 [ %44, %37 ], [ 0, %34 ]
  %40 = getelementptr inbounds double, ptr %16, i64 %38
  %41 = load double, ptr %40, align 8
  %42 = getelementptr inbounds double, ptr %23, i64 %38
  store double %41, ptr %42, align 8
  %43 = add nuw nsw i64 %38, 1
  %44 = add i64 %39, 1
  %45 = icmp eq i64 %44, %28
  br i1 %45, label %46, label %37

46:
  %47 = icmp sgt i64 %4, 0
  br i1 %47, label %48, label %89

48:
  %49 = getelementptr double, ptr %23, i64 %3
  %50 = and i64 %4, 3
  %51 = icmp ult i64 %4, 4
  br i1 %51, label %77, label %52

52:
  %53 = and i64 %4, 9223372036854775804
  br label %96

54:
  %55 = phi i64 [ 0, %30 ], [ %72, %54 ]
  %56 = phi i64 [ 0, %30 ], [ %73, %54 ]
  %57 = getelementptr inbounds double, ptr %16, i64 %55
  %58 = load double, ptr %57, align 8
  %59 = getelementptr inbounds double, ptr %23, i64 %55
  store double %58, ptr %59, align 8
  %60 = or i64 %55, 1
  %61 = getelementptr inbounds double, ptr %16, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = getelementptr inbounds double, ptr %23, i64 %60
  store double %62, ptr %63, align 8
  %64 = or i64 %55, 2
  %65 = getelementptr inbounds double, ptr %16, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = getelementptr inbounds double, ptr %23, i64 %64
  store double %66, ptr %67, align 8
  %68 = or i64 %55, 3
  %69 = getelementptr inbounds double, ptr %16, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds double, ptr %23, i64 %68
  store double %70, ptr %71, align 8
  %72 = add nuw nsw i64 %55, 4
  %73 = add i64 %56, 4
  %74 = icmp eq i64 %73, %31
  br i1 %74, label %32, label %54

75:
  %76 = icmp eq i64 %50, 0
  br i1 %76, label %89, label %77

77:
  %78 = phi i64 [ 0, %48 ], [ %114, %75 ]
  %79 = icmp ne i64 %50, 0
  tail call void @llvm.assume(i1 %79)
  br label %80

80:
  %81 = phi i64 [ %78, %77 ], [ %86, %80 ]
  %82 = phi i64 [ 0, %77 ], [ %87, %80 ]
  %83 = getelementptr inbounds double, ptr %18, i64 %81
  %84 = load double, ptr %83, align 8
  %85 = getelementptr double, ptr %49, i64 %81
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %81, 1
  %87 = add i64 %82, 1
  %88 = icmp eq i64 %87, %50
  br i1 %88, label %89, label %80

89:
  %90 = tail call fastcc i64 @request(ptr %0, i64 4, i64 0) #17
  br i1 %26, label %132, label %91

91:
  %92 = and i64 %3, 3
  %93 = icmp ult i64 %3, 4
  br i1 %93, label %119, label %94

94:
  %95 = and i64 %3, 9223372036854775804
  br label %142

96:
  %97 = phi i64 [ 0, %52 ], [ %114, %96 ]
  %98 = phi i64 [ 0, %52 ], [ %115, %96 ]
  %99 = getelementptr inbounds double, ptr %18, i64 %97
  %100 = load double, ptr %99, align 8
  %101 = getelementptr double, ptr %49, i64 %97
  store double %100, ptr %101, align 8
  %102 = or i64 %97, 1
  %103 = getelementptr inbounds double, ptr %18, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = getelementptr double, ptr %49, i64 %102
  store double %104, ptr %105, align 8
  %106 = or i64 %97, 2
  %107 = getelementptr inbounds double, ptr %18, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = getelementptr double, ptr %49, i64 %106
  store double %108, ptr %109, align 8
  %110 = or i64 %97, 3
  %111 = getelementptr inbounds double, ptr %18, i64 %110
  %112 = load double, ptr %111, align 8
  %113 = getelementptr double, ptr %49, i64 %110
  store double %112, ptr %113, align 8
  %114 = add nuw nsw i64 %97, 4
  %115 = add i64 %98, 4
  %116 = icmp eq i64 %115, %53
  br i1 %116, label %75, label %96

117:
  %118 = icmp eq i64 %92, 0
  br i1 %118, label %132, label %119

119:
  %120 = phi i64 [ 0, %91 ], [ %164, %117 ]
  %121 = icmp ne i64 %92, 0
  tail call void @llvm.assume(i1 %121)
  br label %122

122:
  %123 = phi i64 [ %129, %122 ], [ %120, %119 ]
  %124 = phi i64 [ %130, %122 ], [ 0, %119 ]
  %125 = getelementptr inbounds double, ptr %23, i64 %123
  %126 = load double, ptr %125, align 8
  %127 = getelementptr inbounds double, ptr %16, i64 %123
  store double %126, ptr %127, align 8
  %128 = getelementptr inbounds double, ptr %20, i64 %123
  store double 0.000000e+00, ptr %128, align 8
  %129 = add nuw nsw i64 %123, 1
  %130 = add i64 %124, 1
  %131 = icmp eq i64 %130, %92
  br i1 %131, label %132, label %122

132:
  br i1 %47, label %133, label %167

133:
  %134 = getelementptr double, ptr %23, i64 %3
  %135 = fmul double %1, %1
  %136 = fsub double 1.000000e+00, %135
  %137 = and i64 %3, 1
  %138 = icmp eq i64 %3, 1
  %139 = and i64 %3, 9223372036854775806
  %140 = icmp eq i64 %137, 0
  %141 = icmp ne i64 %137, 0
  br label %169

142:
  %143 = phi i64 [ 0, %94 ], [ %164, %142 ]
  %144 = phi i64 [ 0, %94 ], [ %165, %142 ]
  %145 = getelementptr inbounds double, ptr %23, i64 %143
  %146 = load double, ptr %145, align 8
  %147 = getelementptr inbounds double, ptr %16, i64 %143
  store double %146, ptr %147, align 8
  %148 = getelementptr inbounds double, ptr %20, i64 %143
  store double 0.000000e+00, ptr %148, align 8
  %149 = or i64 %143, 1
  %150 = getelementptr inbounds double, ptr %23, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = getelementptr inbounds double, ptr %16, i64 %149
  store double %151, ptr %152, align 8
  %153 = getelementptr inbounds double, ptr %20, i64 %149
  store double 0.000000e+00, ptr %153, align 8
  %154 = or i64 %143, 2
  %155 = getelementptr inbounds double, ptr %23, i64 %154
  %156 = load double, ptr %155, align 8
  %157 = getelementptr inbounds double, ptr %16, i64 %154
  store double %156, ptr %157, align 8
  %158 = getelementptr inbounds double, ptr %20, i64 %154
  store double 0.000000e+00, ptr %158, align 8
  %159 = or i64 %143, 3
  %160 = getelementptr inbounds double, ptr %23, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = getelementptr inbounds double, ptr %16, i64 %159
  store double %161, ptr %162, align 8
  %163 = getelementptr inbounds double, ptr %20, i64 %159
  store double 0.000000e+00, ptr %163, align 8
  %164 = add nuw nsw i64 %143, 4
  %165 = add i64 %144, 4
  %166 = icmp eq i64 %165, %95
  br i1 %166, label %117, label %142

167:
  %168 = icmp eq i64 %90, 1
  br i1 %168, label %215, label %273

169:
  %170 = phi i64 [ 0, %133 ], [ %193, %190 ]
  %171 = getelementptr double, ptr %134, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = getelementptr inbounds double, ptr %18, i64 %170
  store double %172, ptr %173, align 8
  %174 = getelementptr inbounds double, ptr %10, i64 %170
  %175 = load double, ptr %174, align 8
  %176 = getelementptr inbounds double, ptr %8, i64 %170
  store double %175, ptr %176, align 8
  br i1 %26, label %190, label %177

177:
  %178 = mul nuw nsw i64 %170, %3
  %179 = getelementptr double, ptr %6, i64 %178
  br i1 %138, label %181, label %195

180:
  br i1 %140, label %190, label %181

181:
  %182 = phi double [ %175, %177 ], [ %211, %180 ]
  %183 = phi i64 [ 0, %177 ], [ %212, %180 ]
  tail call void @llvm.assume(i1 %141)
  %184 = getelementptr double, ptr %179, i64 %183
  %185 = load double, ptr %184, align 8
  %186 = getelementptr inbounds double, ptr %14, i64 %183
  %187 = load double, ptr %186, align 8
  %188 = fmul double %185, %187
  %189 = fadd double %182, %188
  store double %189, ptr %176, align 8
  br label %190

190:
  %191 = phi double [ %175, %169 ], [ %211, %180 ], [ %189, %181 ]
  %192 = fmul double %136, %191
  store double %192, ptr %176, align 8
  %193 = add nuw nsw i64 %170, 1
  %194 = icmp eq i64 %193, %4
  br i1 %194, label %167, label %169

195:
  %196 = phi double [ %211, %195 ], [ %175, %177 ]
  %197 = phi i64 [ %212, %195 ], [ 0, %177 ]
  %198 = phi i64 [ %213, %195 ], [ 0, %177 ]
  %199 = getelementptr double, ptr %179, i64 %197
  %200 = load double, ptr %199, align 8
  %201 = getelementptr inbounds double, ptr %14, i64 %197
  %202 = load double, ptr %201, align 8
  %203 = fmul double %200, %202
  %204 = fadd double %196, %203
  store double %204, ptr %176, align 8
  %205 = or i64 %197, 1
  %206 = getelementptr double, ptr %179, i64 %205
  %207 = load double, ptr %206, align 8
  %208 = getelementptr inbounds double, ptr %14, i64 %205
  %209 = load double, ptr %208, align 8
  %210 = fmul double %207, %209
  %211 = fadd double %204, %210
  store double %211, ptr %176, align 8
  %212 = add nuw nsw i64 %197, 2
  %213 = add i64 %198, 2
  %214 = icmp eq i64 %213, %139
  br i1 %214, label %180, label %195

215:
  %216 = tail call fastcc i64 @request(ptr %0, i64 6, i64 0) #17
  %217 = icmp eq i64 %216, 1
  br i1 %217, label %218, label %273

218:
  %219 = tail call fastcc i32 @all_finite(ptr %12, i64 %3) #17
  %220 = icmp eq i32 %219, 0
  %221 = or i1 %220, %26
  br i1 %221, label %273, label %222

222:
  %223 = add nsw i64 %3, -1
  %224 = and i64 %3, 3
  %225 = icmp ult i64 %223, 3
  br i1 %225, label %259, label %226

226:
  %227 = and i64 %3, 9223372036854775804
  br label %228

228:
  %229 = phi i64 [ 0, %226 ], [ %254, %228 ]
  %230 = phi i64 [ 0, %226 ], [ %255, %228 ]
  %231 = getelementptr inbounds double, ptr %12, i64 %229
  %232 = load double, ptr %231, align 8
  %233 = getelementptr inbounds double, ptr %14, i64 %229
  %234 = load double, ptr %233, align 8
  %235 = fadd double %232, %234
  store double %235, ptr %233, align 8
  %236 = or i64 %229, 1
  %237 = getelementptr inbounds double, ptr %12, i64 %236
  %238 = load double, ptr %237, align 8
  %239 = getelementptr inbounds double, ptr %14, i64 %236
  %240 = load double, ptr %239, align 8
  %241 = fadd double %238, %240
  store double %241, ptr %239, align 8
  %242 = or i64 %229, 2
  %243 = getelementptr inbounds double, ptr %12, i64 %242
  %244 = load double, ptr %243, align 8
  %245 = getelementptr inbounds double, ptr %14, i64 %242
  %246 = load double, ptr %245, align 8
  %247 = fadd double %244, %246
  store double %247, ptr %245, align 8
  %248 = or i64 %229, 3
  %249 = getelementptr inbounds double, ptr %12, i64 %248
  %250 = load double, ptr %249, align 8
  %251 = getelementptr inbounds double, ptr %14, i64 %248
  %252 = load double, ptr %251, align 8
  %253 = fadd double %250, %252
  store double %253, ptr %251, align 8
  %254 = add nuw nsw i64 %229, 4
  %255 = add i64 %230, 4
  %256 = icmp eq i64 %255, %227
  br i1 %256, label %257, label %228

257:
  %258 = icmp eq i64 %224, 0
  br i1 %258, label %273, label %259

259:
  %260 = phi i64 [ 0, %222 ], [ %254, %257 ]
  %261 = icmp ne i64 %224, 0
  tail call void @llvm.assume(i1 %261)
  br label %262

262:
  %263 = phi i64 [ %270, %262 ], [ %260, %259 ]
  %264 = phi i64 [ %271, %262 ], [ 0, %259 ]
  %265 = getelementptr inbounds double, ptr %12, i64 %263
  %266 = load double, ptr %265, align 8
  %267 = getelementptr inbounds double, ptr %14, i64 %263
  %268 = load double, ptr %267, align 8
  %269 = fadd double %266, %268
  store double %269, ptr %267, align 8
  %270 = add nuw nsw i64 %263, 1
  %271 = add i64 %264, 1
  %272 = icmp eq i64 %271, %224
  br i1 %272, label %273, label %262

273:
  %274 = phi i64 [ %216, %215 ], [ %90, %167 ], [ 1, %218 ], [ 1, %262 ], [ 1, %257 ]
  tail call fastcc void @release(ptr %0, ptr %23) #17
  br label %275

275:
  %276 = phi i64 [ %274, %273 ], [ 1, %2 ]
  ret i64 %276
}

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg) #14

define internal fastcc i32 @is_called_in(ptr %0, i32 %1, i32 %2, ptr %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 104
  %6 = load i64, ptr %5, align 8
  %7 = zext i32 %1 to i64
  %8 = icmp sge i64 %6, %7
  %9 = zext i32 %2 to i64
  %10 = icmp sle i64 %6, %9
  %11 = select i1 %8, i1 %10, i1 false
  %12 = getelementptr inbounds i8, ptr %0, i64 88
  %13 = load i64, ptr %12, align 8
  %14 = icmp ne i64 %13, 0
  %15 = select i1 %14, i1 %11, i1 false
  br i1 %15, label %18, label %16

16:
  %17 = select i1 %14, ptr %3, ptr @.str.84
  tail call fastcc void @fail(ptr %0, ptr %17) #17
  br label %18

18:
  %19 = load i64, ptr %12, align 8
  %20 = icmp ne i64 %19, 0
  %21 = select i1 %20, i1 %11, i1 false
  %22 = zext i1 %21 to i32
  ret i32 %22
}

define internal fastcc i32 @fits(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = icmp eq i64 %1, %2
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @fail(ptr %0, ptr @.str.92) #17
  br label %6

6:
  %7 = zext i1 %4 to i32
  ret i32 %7
}

define internal fastcc i32 @accelerate(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 72
  %3 = load i64, ptr %2, align 8
  %4 = icmp eq i64 %3, 2
  br i1 %4, label %5, label %8

5:
  %6 = tail call fastcc i64 @request(ptr %0, i64 4, i64 0) #17
  %7 = icmp eq i64 %6, 1
  br i1 %7, label %8, label %14

8:
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
  %12 = tail call fastcc i32 @all_finite(ptr %10, i64 %11) #17
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %16

14:
  %15 = phi i64 [ %6, %5 ], [ 4, %8 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.93, i64 %15, ptr @.str.94) #17
  br label %20

16:
  %17 = load i64, ptr %2, align 8
  %18 = icmp eq i64 %17, 2
  br i1 %18, label %19, label %20

19:
  store i64 1, ptr %2, align 8
  br label %20

20:
  %21 = phi i32 [ 3, %14 ], [ 0, %19 ], [ 0, %16 ]
  ret i32 %21
}

declare double @llvm.fabs.f64(double) #15

declare i32 @llvm.smin.i32(i32, i32) #15

declare i64 @llvm.umax.i64(i64, i64) #15

declare void @llvm.assume(i1) #16

attributes #0 = { nounwind "no-builtins" }
attributes #1 = { nounwind "no-builtins" }
attributes #2 = { nounwind "no-builtins" }
attributes #3 = { nounwind "no-builtins" }
attributes #4 = { nounwind "no-builtins" }
attributes #5 = { nounwind "no-builtins" }
attributes #6 = { nounwind "no-builtins" }
attributes #7 = { nounwind "no-builtins" }
attributes #8 = { nounwind "no-builtins" }
attributes #9 = { nounwind "no-builtins" }
attributes #10 = { nounwind "no-builtins" }
attributes #11 = { nounwind "no-builtins" }
attributes #12 = { nounwind "no-builtins" }
attributes #13 = { nounwind "no-builtins" }
attributes #14 = { nounwind "no-builtins" }
attributes #15 = { nounwind "no-builtins" }
attributes #16 = { nounwind "no-builtins" }
attributes #17 = { nounwind "no-builtins" }
attributes #18 = { nounwind "no-builtins" }
attributes #19 = { nounwind "no-builtins" }


