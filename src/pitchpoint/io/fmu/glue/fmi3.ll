; c6d73bf2b17828d39840aecb57dfc1428c38640bd811d2913802beff10b5dcb3

%struct.Numbers = type { i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, i64, double, double, double }
%struct.Variable = type { i64, i64, i64, double, double, double }
%struct.Place = type { i64, i64, i64, i64, double }
%struct.Callbacks = type { ptr, ptr, ptr, ptr, ptr }
%struct.Instance = type { %struct.Callbacks, ptr, %struct.Clock, ptr, ptr, ptr, ptr, [480 x i8] }
%struct.Clock = type { double, double, i64, i64, i64, i64, i64 }
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
@.str.38 = private unnamed_addr constant [29 x i8] c"the start time is not finite\00", align 1
@.str.39 = private unnamed_addr constant [95 x i8] c"the start time must be that of the model description: drives prescribe positions over the time\00", align 1
@pp_variables = external local_unnamed_addr constant [0 x %struct.Variable], align 8
@pp_places = external constant [0 x %struct.Place], align 8
@pp_balancing = external local_unnamed_addr constant [0 x i32], align 4
@pp_free = external constant [0 x i32], align 4
@.str.40 = private unnamed_addr constant [111 x i8] c"no equilibrium was found for these inputs and parameters: the run starts in the state of the model description\00", align 1
@pp_entries = external local_unnamed_addr constant [0 x ptr], align 8
@pp_free_balancing = external constant [0 x i32], align 4
@pp_instants = external local_unnamed_addr constant [0 x double], align 8
@pp_spins = external local_unnamed_addr constant [0 x i32], align 4
@pp_coefficients = external local_unnamed_addr constant [0 x double], align 8
@pp_entries_of_matrix = external local_unnamed_addr constant [0 x i32], align 4
@.str.41 = private unnamed_addr constant [31 x i8] c"the forces cannot be evaluated\00", align 1
@.str.42 = private unnamed_addr constant [28 x i8] c"check inputs and parameters\00", align 1
@pp_n_sentences = external local_unnamed_addr constant i64, align 8
@.str.43 = private unnamed_addr constant [3 x i8] c": \00", align 1
@pp_sentences = external local_unnamed_addr constant [0 x ptr], align 8
@.str.44 = private unnamed_addr constant [3 x i8] c"; \00", align 1
@pp_image = external constant [0 x i64], align 8
@pp_code = external local_unnamed_addr constant [0 x i32], align 4
@pp_moved = external local_unnamed_addr constant [0 x i32], align 4
@.str.45 = private unnamed_addr constant [53 x i8] c"the numbers of values and of value references differ\00", align 1
@.str.46 = private unnamed_addr constant [65 x i8] c"no variable with a floating-point value has this value reference\00", align 1
@pp_indicators = external local_unnamed_addr constant [0 x i32], align 4
@.str.47 = private unnamed_addr constant [75 x i8] c"coordinates and rates can be set before the end of the initialisation only\00", align 1
@.str.48 = private unnamed_addr constant [50 x i8] c"this variable is neither an input nor a parameter\00", align 1
@.str.49 = private unnamed_addr constant [36 x i8] c"an input or parameter is not finite\00", align 1
@.str.50 = private unnamed_addr constant [51 x i8] c"a parameter is out of the range in its description\00", align 1
@.str.51 = private unnamed_addr constant [32 x i8] c"no place for the state is given\00", align 1
@.str.52 = private unnamed_addr constant [22 x i8] c"no memory for a state\00", align 1
@.str.53 = private unnamed_addr constant [18 x i8] c"no state is given\00", align 1
@.str.54 = private unnamed_addr constant [70 x i8] c"the buffer is smaller than the serialised state, or no state is given\00", align 1
@.str.55 = private unnamed_addr constant [63 x i8] c"these bytes are not a state of this FMU: their number is wrong\00", align 1
@.str.56 = private unnamed_addr constant [39 x i8] c"these bytes are a state of another FMU\00", align 1
@.str.57 = private unnamed_addr constant [60 x i8] c"directional derivatives are for instances of model exchange\00", align 1
@.str.58 = private unnamed_addr constant [53 x i8] c"a known is neither a state nor an input or parameter\00", align 1
@.str.59 = private unnamed_addr constant [21 x i8] c"a seed is not finite\00", align 1
@.str.60 = private unnamed_addr constant [38 x i8] c"no memory for directional derivatives\00", align 1
@.str.61 = private unnamed_addr constant [36 x i8] c"this instance is for model exchange\00", align 1
@.str.62 = private unnamed_addr constant [65 x i8] c"the run has failed before; reset the instance or restore a state\00", align 1
@.str.63 = private unnamed_addr constant [40 x i8] c"the communication step must be positive\00", align 1
@.str.64 = private unnamed_addr constant [53 x i8] c"the communication point is not the time of the model\00", align 1
@.str.65 = private unnamed_addr constant [53 x i8] c"the communication step has more than 1e15 time steps\00", align 1
@.str.66 = private unnamed_addr constant [104 x i8] c"the communication step must be a multiple of the time step: generalised-alpha with constraints keeps it\00", align 1
@.str.67 = private unnamed_addr constant [15 x i8] c"the run failed\00", align 1
@.str.68 = private unnamed_addr constant [67 x i8] c"export it with a shorter time step, or check inputs and parameters\00", align 1
@.str.69 = private unnamed_addr constant [23 x i8] c"the time is not finite\00", align 1
@.str.70 = private unnamed_addr constant [22 x i8] c"a state is not finite\00", align 1
@.str.71 = private unnamed_addr constant [72 x i8] c"the number of states or indicators is not that of the model description\00", align 1
@.str.72 = private unnamed_addr constant [38 x i8] c"the accelerations cannot be evaluated\00", align 1
@.str.73 = private unnamed_addr constant [36 x i8] c"check states, inputs and parameters\00", align 1

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
  %7 = tail call fastcc i32 @set_start(ptr %0, double %3) #17
  ret i32 %7
}

define internal fastcc i32 @set_start(ptr %0, double %1) unnamed_addr #1 {
  %3 = tail call fastcc i32 @finite_number(double %1) #17
  %4 = icmp eq i32 %3, 0
  br i1 %4, label %38, label %5

5:
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 328), align 8
  %7 = icmp ne i64 %6, 0
  %8 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  %9 = fcmp une double %1, %8
  %10 = select i1 %7, i1 %9, i1 false
  br i1 %10, label %38, label %11

11:
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  store double %1, ptr %12, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %13, align 8
  %14 = fcmp oeq double %1, %8
  br i1 %14, label %40, label %15

15:
  %16 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %16, align 8
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %18 = icmp ne i64 %17, 0
  %19 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %20 = icmp sgt i64 %19, 0
  %21 = select i1 %18, i1 %20, i1 false
  br i1 %21, label %22, label %40

22:
  %23 = phi i64 [ %36, %35 ], [ 0, %15 ]
  %24 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %23
  %25 = load i64, ptr %24, align 8
  %26 = icmp eq i64 %25, 7
  br i1 %26, label %27, label %35

27:
  %28 = tail call fastcc ptr @drive_of(ptr %0, i64 %23) #17
  %29 = getelementptr inbounds i8, ptr %28, i64 96
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %28, i64 104
  %32 = load double, ptr %31, align 8
  %33 = fmul double %8, %32
  %34 = fadd double %30, %33
  tail call fastcc void @turn_on(ptr %0, ptr %28, double %34, double %32, double 0.000000e+00) #17
  br label %35

35:
  %36 = add nuw nsw i64 %23, 1
  %37 = icmp slt i64 %36, %19
  br i1 %37, label %22, label %40

38:
  %39 = phi ptr [ @.str.38, %2 ], [ @.str.39, %5 ]
  tail call fastcc void @fail(ptr %0, ptr %39) #17
  br label %40

40:
  %41 = phi i32 [ 0, %15 ], [ 3, %38 ], [ 0, %11 ], [ 0, %35 ]
  ret i32 %41
}

define i32 @fmi3ExitInitializationMode(ptr %0) local_unnamed_addr #1 {
  %2 = tail call fastcc i32 @end_start(ptr %0) #17
  ret i32 %2
}

define internal fastcc i32 @end_start(ptr %0) unnamed_addr #1 {
  %2 = getelementptr inbounds i8, ptr %0, i64 96
  %3 = load i64, ptr %2, align 8
  %4 = icmp eq i64 %3, 1
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 56), align 8
  %6 = icmp ne i64 %5, 0
  %7 = select i1 %4, i1 %6, i1 false
  br i1 %7, label %8, label %91

8:
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 72), align 8
  %10 = icmp sgt i64 %9, 0
  br i1 %10, label %11, label %39

11:
  %12 = getelementptr inbounds i8, ptr %0, i64 104
  %13 = load ptr, ptr %12, align 8
  %14 = and i64 %9, 1
  %15 = icmp eq i64 %9, 1
  br i1 %15, label %20, label %16

16:
  %17 = and i64 %9, 9223372036854775806
  br label %43

18:
  %19 = icmp eq i64 %14, 0
  br i1 %19, label %36, label %20

20:
  %21 = phi i32 [ 1, %11 ], [ %70, %18 ]
  %22 = phi i64 [ 0, %11 ], [ %71, %18 ]
  %23 = icmp ne i64 %14, 0
  tail call void @llvm.assume(i1 %23)
  %24 = shl nuw nsw i64 %22, 3
  %25 = getelementptr inbounds i8, ptr @pp_balancing, i64 %24
  %26 = getelementptr inbounds i8, ptr %25, i64 4
  %27 = load i32, ptr %26, align 4
  %28 = zext i32 %27 to i64
  %29 = getelementptr inbounds double, ptr %13, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %28
  %32 = getelementptr inbounds i8, ptr %31, i64 24
  %33 = load double, ptr %32, align 8
  %34 = fcmp une double %30, %33
  %35 = select i1 %34, i32 0, i32 %21
  br label %36

36:
  %37 = phi i32 [ %70, %18 ], [ %35, %20 ]
  %38 = icmp ne i32 %37, 0
  br label %39

39:
  %40 = phi i1 [ true, %8 ], [ %38, %36 ]
  %41 = icmp ne i64 %9, 0
  %42 = select i1 %41, i1 %40, i1 false
  br i1 %42, label %74, label %77

43:
  %44 = phi i32 [ 1, %16 ], [ %70, %43 ]
  %45 = phi i64 [ 0, %16 ], [ %71, %43 ]
  %46 = phi i64 [ 0, %16 ], [ %72, %43 ]
  %47 = shl nuw nsw i64 %45, 3
  %48 = getelementptr inbounds i8, ptr @pp_balancing, i64 %47
  %49 = getelementptr inbounds i8, ptr %48, i64 4
  %50 = load i32, ptr %49, align 4
  %51 = zext i32 %50 to i64
  %52 = getelementptr inbounds double, ptr %13, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %51
  %55 = getelementptr inbounds i8, ptr %54, i64 24
  %56 = load double, ptr %55, align 8
  %57 = fcmp une double %53, %56
  %58 = shl i64 %45, 3
  %59 = getelementptr inbounds i8, ptr @pp_balancing, i64 %58
  %60 = getelementptr inbounds i8, ptr %59, i64 12
  %61 = load i32, ptr %60, align 4
  %62 = zext i32 %61 to i64
  %63 = getelementptr inbounds double, ptr %13, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %62
  %66 = getelementptr inbounds i8, ptr %65, i64 24
  %67 = load double, ptr %66, align 8
  %68 = fcmp une double %64, %67
  %69 = select i1 %68, i1 true, i1 %57
  %70 = select i1 %69, i32 0, i32 %44
  %71 = add nuw nsw i64 %45, 2
  %72 = add i64 %46, 2
  %73 = icmp eq i64 %72, %17
  br i1 %73, label %18, label %43

74:
  %75 = tail call fastcc i32 @balance(ptr %0) #17
  %76 = icmp eq i32 %75, 0
  br i1 %76, label %80, label %77

77:
  %78 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free, i64 %5) #17
  %79 = icmp eq i32 %78, 0
  br i1 %79, label %80, label %81

80:
  tail call fastcc void @say(ptr %0, i32 1, ptr @.str.40) #17
  br label %81

81:
  %82 = phi i32 [ 0, %77 ], [ 1, %80 ]
  %83 = getelementptr inbounds i8, ptr %0, i64 128
  %84 = load ptr, ptr %83, align 8
  %85 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
  %86 = getelementptr inbounds i8, ptr %84, i64 %85
  %87 = load ptr, ptr getelementptr inbounds (i8, ptr @pp_entries, i64 8), align 8
  %88 = tail call fastcc i64 @address(ptr %86) #17
  %89 = tail call i64 %87(i64 %88, i64 5, i64 0) #19
  %90 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %90, align 8
  br label %91

91:
  %92 = phi i32 [ %82, %81 ], [ 0, %1 ]
  %93 = tail call fastcc i32 @refresh(ptr %0) #17
  %94 = icmp eq i32 %93, 0
  br i1 %94, label %95, label %96

95:
  store i64 3, ptr %2, align 8
  br label %96

96:
  %97 = phi i32 [ %92, %95 ], [ %93, %91 ]
  ret i32 %97
}

define i32 @fmi3Terminate(ptr readnone %0) local_unnamed_addr #0 {
  ret i32 0
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
  %5 = getelementptr inbounds i8, ptr %0, i64 104
  %6 = and i64 %2, 3
  %7 = icmp ult i64 %2, 4
  br i1 %7, label %12, label %8

8:
  %9 = and i64 %2, 9223372036854775804
  br label %33

10:
  %11 = icmp eq i64 %6, 0
  br i1 %11, label %26, label %12

12:
  %13 = phi i64 [ 0, %4 ], [ %59, %10 ]
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
  %28 = load <2 x double>, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 336), align 8
  store <2 x double> %28, ptr %27, align 8
  %29 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %29, align 8
  %30 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 1, ptr %30, align 8
  %31 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 0, ptr %31, align 8
  %32 = getelementptr inbounds i8, ptr %0, i64 96
  store i64 0, ptr %32, align 8
  ret void

33:
  %34 = phi i64 [ 0, %8 ], [ %59, %33 ]
  %35 = phi i64 [ 0, %8 ], [ %60, %33 ]
  %36 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %34
  %37 = getelementptr inbounds i8, ptr %36, i64 24
  %38 = load double, ptr %37, align 8
  %39 = load ptr, ptr %5, align 8
  %40 = getelementptr inbounds double, ptr %39, i64 %34
  store double %38, ptr %40, align 8
  %41 = or i64 %34, 1
  %42 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %41
  %43 = getelementptr inbounds i8, ptr %42, i64 24
  %44 = load double, ptr %43, align 8
  %45 = load ptr, ptr %5, align 8
  %46 = getelementptr inbounds double, ptr %45, i64 %41
  store double %44, ptr %46, align 8
  %47 = or i64 %34, 2
  %48 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %47
  %49 = getelementptr inbounds i8, ptr %48, i64 24
  %50 = load double, ptr %49, align 8
  %51 = load ptr, ptr %5, align 8
  %52 = getelementptr inbounds double, ptr %51, i64 %47
  store double %50, ptr %52, align 8
  %53 = or i64 %34, 3
  %54 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %53
  %55 = getelementptr inbounds i8, ptr %54, i64 24
  %56 = load double, ptr %55, align 8
  %57 = load ptr, ptr %5, align 8
  %58 = getelementptr inbounds double, ptr %57, i64 %53
  store double %56, ptr %58, align 8
  %59 = add nuw nsw i64 %34, 4
  %60 = add i64 %35, 4
  %61 = icmp eq i64 %60, %9
  br i1 %61, label %10, label %33
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
  tail call fastcc void @fail(ptr %0, ptr @.str.45) #17
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
  %8 = getelementptr inbounds i8, ptr %0, i64 128
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 208), align 8
  %10 = getelementptr inbounds i8, ptr %0, i64 104
  %11 = getelementptr inbounds i8, ptr %0, i64 112
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  br label %15

15:
  %16 = phi i64 [ 0, %6 ], [ %70, %67 ]
  %17 = getelementptr inbounds i32, ptr %1, i64 %16
  %18 = load i32, ptr %17, align 4
  %19 = zext i32 %18 to i64
  %20 = icmp sgt i64 %7, %19
  br i1 %20, label %22, label %21

21:
  tail call fastcc void @fail(ptr %0, ptr @.str.46) #17
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
  br i1 %5, label %92, label %6

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %8 = getelementptr inbounds i8, ptr %0, i64 96
  br label %18

9:
  %10 = add nuw i64 %19, 1
  %11 = icmp eq i64 %10, %2
  br i1 %11, label %12, label %18

12:
  %13 = getelementptr inbounds i8, ptr %0, i64 104
  %14 = getelementptr inbounds i8, ptr %0, i64 96
  %15 = getelementptr inbounds i8, ptr %0, i64 88
  %16 = getelementptr inbounds i8, ptr %0, i64 72
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  br label %43

18:
  %19 = phi i64 [ 0, %6 ], [ %10, %9 ]
  %20 = getelementptr inbounds i32, ptr %1, i64 %19
  %21 = load i32, ptr %20, align 4
  %22 = zext i32 %21 to i64
  %23 = icmp sgt i64 %7, %22
  br i1 %23, label %24, label %90

24:
  %25 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %22
  %26 = load i64, ptr %25, align 8
  switch i64 %26, label %30 [
    i64 3, label %27
    i64 6, label %90
    i64 5, label %90
    i64 4, label %90
    i64 0, label %90
  ]

27:
  %28 = load i64, ptr %8, align 8
  %29 = icmp eq i64 %28, 3
  br i1 %29, label %90, label %30

30:
  %31 = getelementptr inbounds double, ptr %3, i64 %19
  %32 = load double, ptr %31, align 8
  %33 = tail call fastcc i32 @finite_number(double %32) #17
  %34 = icmp eq i32 %33, 0
  br i1 %34, label %90, label %35

35:
  %36 = getelementptr inbounds i8, ptr %25, i64 32
  %37 = load double, ptr %36, align 8
  %38 = fcmp olt double %32, %37
  br i1 %38, label %90, label %39

39:
  %40 = getelementptr inbounds i8, ptr %25, i64 40
  %41 = load double, ptr %40, align 8
  %42 = fcmp ogt double %32, %41
  br i1 %42, label %90, label %9

43:
  %44 = phi i64 [ 0, %12 ], [ %88, %87 ]
  %45 = getelementptr inbounds i32, ptr %1, i64 %44
  %46 = load i32, ptr %45, align 4
  %47 = zext i32 %46 to i64
  %48 = getelementptr inbounds %struct.Variable, ptr @pp_variables, i64 %47
  %49 = load i64, ptr %48, align 8
  %50 = icmp eq i64 %49, 3
  br i1 %50, label %51, label %66

51:
  %52 = getelementptr inbounds i8, ptr %48, i64 8
  %53 = load i64, ptr %52, align 8
  %54 = tail call fastcc ptr @state_at(ptr %0, i64 %53) #17
  %55 = load double, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %3, i64 %44
  %57 = load double, ptr %56, align 8
  %58 = fcmp oeq double %55, %57
  br i1 %58, label %87, label %59

59:
  store double %57, ptr %54, align 8
  store i64 2, ptr %16, align 8
  %60 = icmp slt i64 %53, %17
  br i1 %60, label %61, label %62

61:
  store i64 2, ptr %14, align 8
  br label %87

62:
  %63 = load i64, ptr %14, align 8
  %64 = icmp eq i64 %63, 0
  br i1 %64, label %65, label %87

65:
  store i64 1, ptr %14, align 8
  br label %87

66:
  %67 = load ptr, ptr %13, align 8
  %68 = getelementptr inbounds double, ptr %67, i64 %47
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds double, ptr %3, i64 %44
  %71 = load double, ptr %70, align 8
  %72 = fcmp oeq double %69, %71
  br i1 %72, label %87, label %73

73:
  store double %71, ptr %68, align 8
  %74 = load i64, ptr %14, align 8
  %75 = icmp eq i64 %74, 0
  br i1 %75, label %76, label %77

76:
  store i64 1, ptr %14, align 8
  br label %77

77:
  %78 = add i64 %49, -1
  %79 = icmp ult i64 %78, 2
  br i1 %79, label %80, label %83

80:
  %81 = load i32, ptr %45, align 4
  %82 = zext i32 %81 to i64
  tail call fastcc void @put(ptr %0, i64 %82) #17
  br label %86

83:
  %84 = load i64, ptr %15, align 8
  %85 = icmp eq i64 %84, 0
  br i1 %85, label %87, label %86

86:
  store i64 2, ptr %16, align 8
  br label %87

87:
  %88 = add nuw i64 %44, 1
  %89 = icmp eq i64 %88, %2
  br i1 %89, label %92, label %43

90:
  %91 = phi ptr [ @.str.48, %24 ], [ @.str.47, %27 ], [ @.str.49, %30 ], [ @.str.48, %18 ], [ @.str.48, %24 ], [ @.str.48, %24 ], [ @.str.48, %24 ], [ @.str.50, %39 ], [ @.str.50, %35 ]
  tail call fastcc void @fail(ptr %0, ptr %91) #17
  br label %92

92:
  %93 = phi i32 [ 0, %4 ], [ 3, %90 ], [ 0, %87 ]
  ret i32 %93
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
  %25 = tail call ptr @memcpy(ptr %23, ptr %24, i64 56) #19
  %26 = getelementptr inbounds i8, ptr %12, i64 96
  %27 = getelementptr inbounds i8, ptr %0, i64 104
  %28 = load ptr, ptr %27, align 8
  %29 = tail call ptr @memcpy(ptr %26, ptr %28, i64 %22) #19
  %30 = getelementptr inbounds i8, ptr %26, i64 %22
  %31 = getelementptr inbounds i8, ptr %0, i64 128
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
  %97 = phi ptr [ @.str.51, %2 ], [ @.str.52, %7 ]
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
  tail call fastcc void @fail(ptr %0, ptr @.str.53) #17
  br label %18

5:
  %6 = tail call fastcc i64 @numbers_of_state() #17
  %7 = shl i64 %6, 3
  %8 = getelementptr inbounds i8, ptr %0, i64 48
  %9 = getelementptr inbounds i8, ptr %0, i64 88
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds i8, ptr %1, i64 40
  %12 = tail call ptr @memcpy(ptr %8, ptr %11, i64 56) #19
  %13 = getelementptr inbounds i8, ptr %0, i64 104
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds i8, ptr %1, i64 96
  %16 = tail call ptr @memcpy(ptr %14, ptr %15, i64 %7) #19
  %17 = getelementptr inbounds i8, ptr %15, i64 %7
  tail call fastcc void @relocate(ptr %0, ptr %17) #17
  store i64 %10, ptr %9, align 8
  br label %18

18:
  %19 = phi i32 [ 0, %5 ], [ 3, %4 ]
  ret i32 %19
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

define i32 @fmi3SerializedFMUStateSize(ptr readnone %0, ptr readnone %1, ptr %2) local_unnamed_addr #2 {
  %4 = tail call fastcc i64 @state_size() #17
  store i64 %4, ptr %2, align 8
  ret i32 0
}

define internal fastcc i64 @state_size() unnamed_addr #0 {
  %1 = tail call fastcc i64 @numbers_of_state() #17
  %2 = shl i64 %1, 3
  %3 = add i64 %2, 96
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
  tail call fastcc void @fail(ptr %0, ptr @.str.54) #17
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
  br i1 %6, label %20, label %7

7:
  tail call fastcc void @fail(ptr %0, ptr @.str.55) #17
  br label %40

8:
  %9 = or i64 %21, 1
  %10 = getelementptr inbounds i8, ptr @pp_token, i64 %9
  %11 = load i8, ptr %10, align 1
  %12 = icmp eq i8 %11, 0
  br i1 %12, label %30, label %13

13:
  %14 = getelementptr inbounds i8, ptr %1, i64 %9
  %15 = load i8, ptr %14, align 1
  %16 = icmp eq i8 %15, %11
  br i1 %16, label %17, label %29

17:
  %18 = add nuw nsw i64 %21, 2
  %19 = icmp eq i64 %18, 40
  br i1 %19, label %30, label %20

20:
  %21 = phi i64 [ %18, %17 ], [ 0, %4 ]
  %22 = getelementptr inbounds i8, ptr @pp_token, i64 %21
  %23 = load i8, ptr %22, align 1
  %24 = icmp eq i8 %23, 0
  br i1 %24, label %30, label %25

25:
  %26 = getelementptr inbounds i8, ptr %1, i64 %21
  %27 = load i8, ptr %26, align 1
  %28 = icmp eq i8 %27, %23
  br i1 %28, label %8, label %29

29:
  tail call fastcc void @fail(ptr %0, ptr @.str.56) #17
  br label %40

30:
  %31 = load ptr, ptr %3, align 8
  %32 = icmp eq ptr %31, null
  br i1 %32, label %33, label %37

33:
  %34 = tail call fastcc ptr @allocate(ptr %0, i64 %2) #17
  store ptr %34, ptr %3, align 8
  %35 = icmp eq ptr %34, null
  br i1 %35, label %36, label %37

36:
  tail call fastcc void @fail(ptr %0, ptr @.str.52) #17
  br label %40

37:
  %38 = phi ptr [ %34, %33 ], [ %31, %30 ]
  %39 = tail call ptr @memcpy(ptr %38, ptr %1, i64 %2) #19
  br label %40

40:
  %41 = phi i32 [ 3, %7 ], [ 0, %37 ], [ 3, %36 ], [ 3, %29 ]
  ret i32 %41
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
  tail call fastcc void @fail(ptr %0, ptr @.str.57) #17
  br label %160

17:
  %18 = phi double [ 1.000000e+300, %12 ], [ %49, %48 ]
  %19 = icmp eq i64 %2, 0
  br i1 %19, label %160, label %20

20:
  %21 = and i64 %2, 7
  %22 = icmp ult i64 %2, 8
  br i1 %22, label %54, label %23

23:
  %24 = and i64 %2, -8
  br label %66

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
  tail call fastcc void @fail(ptr %0, ptr @.str.58) #17
  br label %160

36:
  %37 = getelementptr inbounds double, ptr %5, i64 %27
  %38 = load double, ptr %37, align 8
  %39 = tail call fastcc i32 @finite_number(double %38) #17
  %40 = icmp eq i32 %39, 0
  br i1 %40, label %41, label %42

41:
  tail call fastcc void @fail(ptr %0, ptr @.str.59) #17
  br label %160

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
  %55 = phi i64 [ 0, %20 ], [ %84, %52 ]
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
  br i1 %65, label %87, label %160

66:
  %67 = phi i64 [ 0, %23 ], [ %84, %66 ]
  %68 = phi i64 [ 0, %23 ], [ %85, %66 ]
  %69 = getelementptr inbounds double, ptr %6, i64 %67
  store double 0.000000e+00, ptr %69, align 8
  %70 = getelementptr inbounds double, ptr %6, i64 %67
  %71 = getelementptr inbounds i8, ptr %70, i64 8
  store double 0.000000e+00, ptr %71, align 8
  %72 = getelementptr inbounds double, ptr %6, i64 %67
  %73 = getelementptr inbounds i8, ptr %72, i64 16
  store double 0.000000e+00, ptr %73, align 8
  %74 = getelementptr inbounds double, ptr %6, i64 %67
  %75 = getelementptr inbounds i8, ptr %74, i64 24
  store double 0.000000e+00, ptr %75, align 8
  %76 = getelementptr inbounds double, ptr %6, i64 %67
  %77 = getelementptr inbounds i8, ptr %76, i64 32
  store double 0.000000e+00, ptr %77, align 8
  %78 = getelementptr inbounds double, ptr %6, i64 %67
  %79 = getelementptr inbounds i8, ptr %78, i64 40
  store double 0.000000e+00, ptr %79, align 8
  %80 = getelementptr inbounds double, ptr %6, i64 %67
  %81 = getelementptr inbounds i8, ptr %80, i64 48
  store double 0.000000e+00, ptr %81, align 8
  %82 = getelementptr inbounds double, ptr %6, i64 %67
  %83 = getelementptr inbounds i8, ptr %82, i64 56
  store double 0.000000e+00, ptr %83, align 8
  %84 = add nuw i64 %67, 8
  %85 = add i64 %68, 8
  %86 = icmp eq i64 %85, %24
  br i1 %86, label %52, label %66

87:
  store ptr null, ptr %8, align 8
  %88 = shl i64 %2, 3
  %89 = tail call fastcc ptr @allocate(ptr %0, i64 %88) #17
  %90 = icmp eq ptr %89, null
  br i1 %90, label %91, label %92

91:
  tail call fastcc void @fail(ptr %0, ptr @.str.60) #17
  br label %129

92:
  %93 = call fastcc i32 @keep_state(ptr %0, ptr %8) #17
  %94 = icmp eq i32 %93, 0
  br i1 %94, label %95, label %129

95:
  %96 = fneg double %18
  %97 = call fastcc i32 @add(ptr %0, ptr %3, i64 %4, ptr %5, double %96) #17
  %98 = icmp eq i32 %97, 0
  br i1 %98, label %99, label %129

99:
  %100 = call fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %89) #17
  %101 = icmp eq i32 %100, 0
  br i1 %101, label %102, label %129

102:
  %103 = load ptr, ptr %8, align 8
  %104 = call fastcc i32 @restore(ptr %0, ptr %103) #17
  %105 = icmp eq i32 %104, 0
  br i1 %105, label %106, label %132

106:
  %107 = call fastcc i32 @add(ptr %0, ptr %3, i64 %4, ptr %5, double %18) #17
  %108 = icmp eq i32 %107, 0
  br i1 %108, label %109, label %129

109:
  %110 = call fastcc i32 @get_numbers(ptr %0, ptr %1, i64 %2, ptr %6) #17
  %111 = icmp eq i32 %110, 0
  br i1 %111, label %112, label %129

112:
  %113 = fmul double %18, 2.000000e+00
  %114 = and i64 %2, 1
  %115 = icmp eq i64 %2, 1
  br i1 %115, label %120, label %116

116:
  %117 = and i64 %2, -2
  br label %136

118:
  %119 = icmp eq i64 %114, 0
  br i1 %119, label %129, label %120

120:
  %121 = phi i64 [ 0, %112 ], [ %152, %118 ]
  %122 = icmp ne i64 %114, 0
  call void @llvm.assume(i1 %122)
  %123 = getelementptr inbounds double, ptr %6, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = getelementptr inbounds double, ptr %89, i64 %121
  %126 = load double, ptr %125, align 8
  %127 = fsub double %124, %126
  %128 = fdiv double %127, %113
  store double %128, ptr %123, align 8
  br label %129

129:
  %130 = phi i32 [ %107, %106 ], [ %100, %99 ], [ %97, %95 ], [ 3, %91 ], [ %93, %92 ], [ %110, %109 ], [ 0, %118 ], [ 0, %120 ]
  %131 = load ptr, ptr %8, align 8
  br label %132

132:
  %133 = phi ptr [ %131, %129 ], [ %103, %102 ]
  %134 = phi i32 [ %130, %129 ], [ %104, %102 ]
  %135 = icmp eq ptr %133, null
  br i1 %135, label %157, label %155

136:
  %137 = phi i64 [ 0, %116 ], [ %152, %136 ]
  %138 = phi i64 [ 0, %116 ], [ %153, %136 ]
  %139 = getelementptr inbounds double, ptr %6, i64 %137
  %140 = load double, ptr %139, align 8
  %141 = getelementptr inbounds double, ptr %89, i64 %137
  %142 = load double, ptr %141, align 8
  %143 = fsub double %140, %142
  %144 = fdiv double %143, %113
  store double %144, ptr %139, align 8
  %145 = or i64 %137, 1
  %146 = getelementptr inbounds double, ptr %6, i64 %145
  %147 = load double, ptr %146, align 8
  %148 = getelementptr inbounds double, ptr %89, i64 %145
  %149 = load double, ptr %148, align 8
  %150 = fsub double %147, %149
  %151 = fdiv double %150, %113
  store double %151, ptr %146, align 8
  %152 = add nuw i64 %137, 2
  %153 = add i64 %138, 2
  %154 = icmp eq i64 %153, %117
  br i1 %154, label %118, label %136

155:
  %156 = call fastcc i32 @restore(ptr %0, ptr %133) #17
  br label %157

157:
  call fastcc void @drop_state(ptr %0, ptr %8) #17
  br i1 %90, label %159, label %158

158:
  call fastcc void @release(ptr %0, ptr %89) #17
  br label %159

159:
  br label %160

160:
  %161 = phi i32 [ %134, %159 ], [ 3, %16 ], [ 0, %64 ], [ 3, %35 ], [ 3, %41 ], [ 0, %17 ]
  ret i32 %161
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
  tail call fastcc void @fail(ptr %0, ptr @.str.61) #17
  br label %81

18:
  %19 = getelementptr inbounds i8, ptr %0, i64 80
  %20 = load i64, ptr %19, align 8
  %21 = icmp eq i64 %20, 0
  br i1 %21, label %23, label %22

22:
  tail call fastcc void @fail(ptr %0, ptr @.str.62) #17
  br label %81

23:
  %24 = fcmp ogt double %2, 0.000000e+00
  %25 = fcmp olt double %2, 1.000000e+300
  %26 = and i1 %24, %25
  br i1 %26, label %28, label %27

27:
  tail call fastcc void @fail(ptr %0, ptr @.str.63) #17
  br label %81

28:
  %29 = fcmp ugt double %5, %13
  %30 = fneg double %5
  %31 = fcmp ult double %13, %30
  %32 = or i1 %29, %31
  br i1 %32, label %33, label %34

33:
  tail call fastcc void @fail(ptr %0, ptr @.str.64) #17
  br label %81

34:
  %35 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 344), align 8
  %36 = fdiv double %2, %35
  %37 = fmul double %36, 0x3FEFFFFFFF768FA1
  %38 = fcmp ogt double %37, 1.000000e+15
  br i1 %38, label %39, label %40

39:
  tail call fastcc void @fail(ptr %0, ptr @.str.65) #17
  br label %81

40:
  %41 = fptosi double %37 to i64
  %42 = add nsw i64 %41, 1
  %43 = sitofp i64 %42 to double
  %44 = fdiv double %2, %43
  %45 = fsub double %44, %7
  %46 = fmul double %44, 1.000000e-09
  %47 = fcmp ogt double %45, %46
  %48 = fneg double %45
  %49 = fcmp olt double %46, %48
  %50 = or i1 %47, %49
  br i1 %50, label %51, label %59

51:
  %52 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 312), align 8
  %53 = icmp ne i64 %52, 0
  %54 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 264), align 8
  %55 = icmp ne i64 %54, 0
  %56 = select i1 %53, i1 %55, i1 false
  br i1 %56, label %57, label %58

57:
  tail call fastcc void @fail(ptr %0, ptr @.str.66) #17
  br label %81

58:
  tail call fastcc void @change_step(ptr %0, double %44) #17
  br label %59

59:
  tail call fastcc void @lead(ptr %0, double %2) #17
  %60 = getelementptr inbounds i8, ptr %0, i64 72
  %61 = load i64, ptr %60, align 8
  %62 = icmp eq i64 %61, 2
  br i1 %62, label %63, label %65

63:
  %64 = tail call fastcc i64 @restart(ptr %0) #17
  br label %65

65:
  %66 = phi i64 [ %64, %63 ], [ 1, %59 ]
  %67 = icmp eq i64 %66, 1
  %68 = icmp sgt i64 %41, 0
  %69 = and i1 %68, %67
  br i1 %69, label %70, label %72

70:
  %71 = tail call fastcc i64 @advance(ptr %0, i64 %41, i64 0) #17
  br label %72

72:
  %73 = phi i64 [ %71, %70 ], [ %66, %65 ]
  %74 = icmp eq i64 %73, 1
  br i1 %74, label %76, label %75

75:
  store i64 0, ptr %60, align 8
  br label %79

76:
  %77 = tail call fastcc i64 @advance(ptr %0, i64 1, i64 1) #17
  store i64 0, ptr %60, align 8
  %78 = icmp eq i64 %77, 1
  br i1 %78, label %81, label %79

79:
  %80 = phi i64 [ %73, %75 ], [ %77, %76 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.67, i64 %80, ptr @.str.68) #17
  br label %81

81:
  %82 = phi i32 [ 3, %17 ], [ 3, %22 ], [ 3, %27 ], [ 3, %33 ], [ 3, %39 ], [ 3, %57 ], [ 3, %79 ], [ 0, %76 ]
  ret i32 %82
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


define i32 @fmi3EnterEventMode(ptr readnone %0) local_unnamed_addr #0 {
  ret i32 0
}

define i32 @fmi3UpdateDiscreteStates(ptr readnone %0, ptr %1, ptr %2, ptr %3, ptr %4, ptr %5, ptr %6) local_unnamed_addr #2 {
  store i8 0, ptr %5, align 1
  store i8 0, ptr %4, align 1
  store i8 0, ptr %3, align 1
  store i8 0, ptr %2, align 1
  store i8 0, ptr %1, align 1
  store double 0.000000e+00, ptr %6, align 8
  ret i32 0
}

define i32 @fmi3EnterContinuousTimeMode(ptr readnone %0) local_unnamed_addr #0 {
  ret i32 0
}

define i32 @fmi3CompletedIntegratorStep(ptr readnone %0, i1 zeroext %1, ptr %2, ptr %3) local_unnamed_addr #2 {
  store i8 0, ptr %2, align 1
  store i8 0, ptr %3, align 1
  ret i32 0
}

define i32 @fmi3SetTime(ptr %0, double %1) local_unnamed_addr #1 {
  %3 = tail call fastcc i32 @set_time(ptr %0, double %1) #17
  ret i32 %3
}

define internal fastcc i32 @set_time(ptr %0, double %1) unnamed_addr #1 {
  %3 = tail call fastcc i32 @finite_number(double %1) #17
  %4 = icmp eq i32 %3, 0
  br i1 %4, label %5, label %6

5:
  tail call fastcc void @fail(ptr %0, ptr @.str.69) #17
  br label %14

6:
  %7 = tail call fastcc double @now(ptr %0) #17
  %8 = fcmp une double %1, %7
  br i1 %8, label %9, label %11

9:
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %10, align 8
  br label %11

11:
  %12 = getelementptr inbounds i8, ptr %0, i64 48
  store double %1, ptr %12, align 8
  %13 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %13, align 8
  br label %14

14:
  %15 = phi i32 [ 0, %11 ], [ 3, %5 ]
  ret i32 %15
}

define i32 @fmi3SetContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @set_states(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @set_states(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %5 = shl nsw i64 %4, 1
  %6 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %5) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %22, label %8

8:
  %9 = tail call fastcc i32 @all_finite(ptr %1, i64 %5) #17
  %10 = icmp eq i32 %9, 0
  br i1 %10, label %11, label %12

11:
  tail call fastcc void @fail(ptr %0, ptr @.str.70) #17
  br label %22

12:
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %14 = tail call fastcc ptr @reals(ptr %0, i64 %13) #17
  %15 = shl i64 %4, 3
  %16 = tail call ptr @memcpy(ptr %14, ptr %1, i64 %15) #19
  %17 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %18 = tail call fastcc ptr @reals(ptr %0, i64 %17) #17
  %19 = getelementptr inbounds double, ptr %1, i64 %4
  %20 = tail call ptr @memcpy(ptr %18, ptr %19, i64 %15) #19
  %21 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 2, ptr %21, align 8
  br label %22

22:
  %23 = phi i32 [ 0, %12 ], [ 3, %11 ], [ 3, %3 ]
  ret i32 %23
}

define i32 @fmi3GetContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_states(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_states(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %5 = shl nsw i64 %4, 1
  %6 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %5) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %17, label %8

8:
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = shl i64 %4, 3
  %12 = tail call ptr @memcpy(ptr %1, ptr %10, i64 %11) #19
  %13 = getelementptr inbounds double, ptr %1, i64 %4
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %15 = tail call fastcc ptr @reals(ptr %0, i64 %14) #17
  %16 = tail call ptr @memcpy(ptr %13, ptr %15, i64 %11) #19
  br label %17

17:
  %18 = phi i32 [ 0, %8 ], [ 3, %3 ]
  ret i32 %18
}

define i32 @fmi3GetContinuousStateDerivatives(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_slopes(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_slopes(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %5 = shl nsw i64 %4, 1
  %6 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %5) #17
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %21, label %8

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 0, ptr %9, align 8
  %10 = tail call fastcc i32 @accelerate(ptr %0) #17
  %11 = icmp eq i32 %10, 0
  br i1 %11, label %12, label %21

12:
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %14 = tail call fastcc ptr @reals(ptr %0, i64 %13) #17
  %15 = shl i64 %4, 3
  %16 = tail call ptr @memcpy(ptr %1, ptr %14, i64 %15) #19
  %17 = getelementptr inbounds double, ptr %1, i64 %4
  %18 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %19 = tail call fastcc ptr @reals(ptr %0, i64 %18) #17
  %20 = tail call ptr @memcpy(ptr %17, ptr %19, i64 %15) #19
  br label %21

21:
  %22 = phi i32 [ 3, %3 ], [ 0, %12 ], [ 2, %8 ]
  ret i32 %22
}

define i32 @fmi3GetEventIndicators(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_indicators(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_indicators(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 32), align 8
  %5 = tail call fastcc i32 @fits(ptr %0, i64 %2, i64 %4) #17
  %6 = icmp eq i32 %5, 0
  br i1 %6, label %28, label %7

7:
  %8 = icmp eq i64 %2, 0
  br i1 %8, label %28, label %9

9:
  %10 = getelementptr inbounds i8, ptr %0, i64 128
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 208), align 8
  %13 = getelementptr inbounds i8, ptr %11, i64 %12
  %14 = tail call fastcc i64 @address(ptr %13) #17
  %15 = tail call fastcc i64 @request(ptr %0, i64 3, i64 %14) #17
  %16 = icmp eq i64 %15, 1
  br i1 %16, label %17, label %28

17:
  %18 = phi i64 [ %26, %17 ], [ 0, %9 ]
  %19 = tail call fastcc ptr @reals(ptr %0, i64 %12) #17
  %20 = getelementptr inbounds i32, ptr @pp_indicators, i64 %18
  %21 = load i32, ptr %20, align 4
  %22 = zext i32 %21 to i64
  %23 = getelementptr inbounds double, ptr %19, i64 %22
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %1, i64 %18
  store double %24, ptr %25, align 8
  %26 = add nuw i64 %18, 1
  %27 = icmp eq i64 %26, %2
  br i1 %27, label %28, label %17

28:
  %29 = phi i32 [ 0, %7 ], [ 3, %3 ], [ 2, %9 ], [ 0, %17 ]
  ret i32 %29
}

define i32 @fmi3GetNominalsOfContinuousStates(ptr %0, ptr %1, i64 %2) local_unnamed_addr #1 {
  %4 = tail call fastcc i32 @get_nominals(ptr %0, ptr %1, i64 %2) #17
  ret i32 %4
}

define internal fastcc i32 @get_nominals(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
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

define i32 @fmi3GetNumberOfEventIndicators(ptr readnone %0, ptr %1) local_unnamed_addr #2 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 32), align 8
  store i64 %3, ptr %1, align 8
  ret i32 0
}

define i32 @fmi3GetNumberOfContinuousStates(ptr readnone %0, ptr %1) local_unnamed_addr #2 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
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
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 320), align 8
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
  %32 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 272), align 8
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
  %44 = getelementptr inbounds i8, ptr %39, i64 128
  store ptr %43, ptr %44, align 8
  %45 = getelementptr inbounds i8, ptr %43, i64 %35
  %46 = getelementptr inbounds i8, ptr %39, i64 104
  store ptr %45, ptr %46, align 8
  %47 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %48 = getelementptr inbounds double, ptr %45, i64 %47
  %49 = getelementptr inbounds i8, ptr %39, i64 112
  store ptr %48, ptr %49, align 8
  %50 = getelementptr inbounds double, ptr %48, i64 %32
  %51 = getelementptr inbounds i8, ptr %39, i64 120
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
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 272), align 8
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
  %3 = getelementptr inbounds i8, ptr %0, i64 128
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

define internal fastcc i32 @balance(ptr %0) unnamed_addr #1 {
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 72), align 8
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %5 = tail call fastcc ptr @reals(ptr %0, i64 %4) #17
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %7 = tail call fastcc ptr @reals(ptr %0, i64 %6) #17
  %8 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 144), align 8
  %9 = tail call fastcc ptr @reals(ptr %0, i64 %8) #17
  %10 = add nsw i64 %3, %2
  %11 = shl nsw i64 %10, 3
  %12 = tail call fastcc ptr @allocate(ptr %0, i64 %11) #17
  %13 = getelementptr inbounds double, ptr %12, i64 %2
  %14 = icmp eq ptr %12, null
  br i1 %14, label %287, label %15

15:
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 64), align 8
  %17 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free_balancing, i64 %16) #17
  %18 = icmp ne i32 %17, 0
  %19 = icmp sgt i64 %2, 0
  %20 = and i1 %18, %19
  br i1 %20, label %21, label %40

21:
  %22 = and i64 %2, 3
  %23 = icmp ult i64 %2, 4
  br i1 %23, label %28, label %24

24:
  %25 = and i64 %2, 9223372036854775804
  br label %64

26:
  %27 = icmp eq i64 %22, 0
  br i1 %27, label %40, label %28

28:
  %29 = phi i64 [ 0, %21 ], [ %82, %26 ]
  %30 = icmp ne i64 %22, 0
  tail call void @llvm.assume(i1 %30)
  br label %31

31:
  %32 = phi i64 [ %37, %31 ], [ %29, %28 ]
  %33 = phi i64 [ %38, %31 ], [ 0, %28 ]
  %34 = getelementptr inbounds double, ptr %5, i64 %32
  %35 = load double, ptr %34, align 8
  %36 = getelementptr inbounds double, ptr %12, i64 %32
  store double %35, ptr %36, align 8
  %37 = add nuw nsw i64 %32, 1
  %38 = add i64 %33, 1
  %39 = icmp eq i64 %38, %22
  br i1 %39, label %40, label %31

40:
  %41 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 80), align 8
  %42 = icmp sgt i64 %41, 0
  %43 = select i1 %18, i1 %42, i1 false
  br i1 %43, label %44, label %85

44:
  %45 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 88), align 8
  %46 = icmp sgt i64 %45, 0
  %47 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 64), align 8
  %48 = icmp sgt i64 %3, 0
  %49 = and i64 %2, 3
  %50 = icmp ult i64 %2, 4
  %51 = and i64 %2, 9223372036854775804
  %52 = icmp eq i64 %49, 0
  %53 = icmp ne i64 %49, 0
  %54 = and i64 %45, 1
  %55 = icmp eq i64 %45, 1
  %56 = and i64 %45, 9223372036854775806
  %57 = icmp eq i64 %54, 0
  %58 = icmp ne i64 %54, 0
  %59 = and i64 %3, 1
  %60 = icmp eq i64 %3, 1
  %61 = and i64 %3, 9223372036854775806
  %62 = icmp eq i64 %59, 0
  %63 = icmp ne i64 %59, 0
  br label %92

64:
  %65 = phi i64 [ 0, %24 ], [ %82, %64 ]
  %66 = phi i64 [ 0, %24 ], [ %83, %64 ]
  %67 = getelementptr inbounds double, ptr %5, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %12, i64 %65
  store double %68, ptr %69, align 8
  %70 = or i64 %65, 1
  %71 = getelementptr inbounds double, ptr %5, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %12, i64 %70
  store double %72, ptr %73, align 8
  %74 = or i64 %65, 2
  %75 = getelementptr inbounds double, ptr %5, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = getelementptr inbounds double, ptr %12, i64 %74
  store double %76, ptr %77, align 8
  %78 = or i64 %65, 3
  %79 = getelementptr inbounds double, ptr %5, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = getelementptr inbounds double, ptr %12, i64 %78
  store double %80, ptr %81, align 8
  %82 = add nuw nsw i64 %65, 4
  %83 = add i64 %66, 4
  %84 = icmp eq i64 %83, %25
  br i1 %84, label %26, label %64

85:
  %86 = phi double [ 0.000000e+00, %40 ], [ %224, %223 ]
  br i1 %20, label %87, label %241

87:
  %88 = and i64 %2, 3
  %89 = icmp ult i64 %2, 4
  br i1 %89, label %229, label %90

90:
  %91 = and i64 %2, 9223372036854775804
  br label %248

92:
  %93 = phi double [ 0.000000e+00, %44 ], [ %224, %223 ]
  %94 = phi i64 [ 0, %44 ], [ %225, %223 ]
  %95 = shl nuw nsw i64 %94, 4
  %96 = getelementptr inbounds i8, ptr @pp_instants, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = getelementptr inbounds i8, ptr %96, i64 8
  %99 = load double, ptr %98, align 8
  %100 = fcmp ogt double %99, 0.000000e+00
  br i1 %100, label %101, label %223

101:
  br i1 %19, label %102, label %115

102:
  br i1 %50, label %104, label %117

103:
  br i1 %52, label %115, label %104

104:
  %105 = phi i64 [ 0, %102 ], [ %135, %103 ]
  tail call void @llvm.assume(i1 %53)
  br label %106

106:
  %107 = phi i64 [ %112, %106 ], [ %105, %104 ]
  %108 = phi i64 [ %113, %106 ], [ 0, %104 ]
  %109 = getelementptr inbounds double, ptr %12, i64 %107
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds double, ptr %5, i64 %107
  store double %110, ptr %111, align 8
  %112 = add nuw nsw i64 %107, 1
  %113 = add i64 %108, 1
  %114 = icmp eq i64 %113, %49
  br i1 %114, label %115, label %106

115:
  br i1 %46, label %116, label %150

116:
  br i1 %55, label %139, label %152

117:
  %118 = phi i64 [ %135, %117 ], [ 0, %102 ]
  %119 = phi i64 [ %136, %117 ], [ 0, %102 ]
  %120 = getelementptr inbounds double, ptr %12, i64 %118
  %121 = load double, ptr %120, align 8
  %122 = getelementptr inbounds double, ptr %5, i64 %118
  store double %121, ptr %122, align 8
  %123 = or i64 %118, 1
  %124 = getelementptr inbounds double, ptr %12, i64 %123
  %125 = load double, ptr %124, align 8
  %126 = getelementptr inbounds double, ptr %5, i64 %123
  store double %125, ptr %126, align 8
  %127 = or i64 %118, 2
  %128 = getelementptr inbounds double, ptr %12, i64 %127
  %129 = load double, ptr %128, align 8
  %130 = getelementptr inbounds double, ptr %5, i64 %127
  store double %129, ptr %130, align 8
  %131 = or i64 %118, 3
  %132 = getelementptr inbounds double, ptr %12, i64 %131
  %133 = load double, ptr %132, align 8
  %134 = getelementptr inbounds double, ptr %5, i64 %131
  store double %133, ptr %134, align 8
  %135 = add nuw nsw i64 %118, 4
  %136 = add i64 %119, 4
  %137 = icmp eq i64 %136, %51
  br i1 %137, label %103, label %117

138:
  br i1 %57, label %150, label %139

139:
  %140 = phi i64 [ 0, %116 ], [ %174, %138 ]
  tail call void @llvm.assume(i1 %58)
  %141 = getelementptr inbounds i32, ptr @pp_spins, i64 %140
  %142 = load i32, ptr %141, align 4
  %143 = zext i32 %142 to i64
  %144 = getelementptr inbounds double, ptr %7, i64 %143
  %145 = load double, ptr %144, align 8
  %146 = fmul double %97, %145
  %147 = getelementptr inbounds double, ptr %5, i64 %143
  %148 = load double, ptr %147, align 8
  %149 = fadd double %148, %146
  store double %149, ptr %147, align 8
  br label %150

150:
  %151 = fcmp une double %97, 0.000000e+00
  br i1 %151, label %177, label %180

152:
  %153 = phi i64 [ %174, %152 ], [ 0, %116 ]
  %154 = phi i64 [ %175, %152 ], [ 0, %116 ]
  %155 = getelementptr inbounds i32, ptr @pp_spins, i64 %153
  %156 = load i32, ptr %155, align 4
  %157 = zext i32 %156 to i64
  %158 = getelementptr inbounds double, ptr %7, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = fmul double %97, %159
  %161 = getelementptr inbounds double, ptr %5, i64 %157
  %162 = load double, ptr %161, align 8
  %163 = fadd double %162, %160
  store double %163, ptr %161, align 8
  %164 = getelementptr inbounds i32, ptr @pp_spins, i64 %153
  %165 = getelementptr inbounds i8, ptr %164, i64 4
  %166 = load i32, ptr %165, align 4
  %167 = zext i32 %166 to i64
  %168 = getelementptr inbounds double, ptr %7, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = fmul double %97, %169
  %171 = getelementptr inbounds double, ptr %5, i64 %167
  %172 = load double, ptr %171, align 8
  %173 = fadd double %172, %170
  store double %173, ptr %171, align 8
  %174 = add nuw nsw i64 %153, 2
  %175 = add i64 %154, 2
  %176 = icmp eq i64 %175, %56
  br i1 %176, label %138, label %152

177:
  %178 = tail call fastcc i32 @settle(ptr %0, ptr @pp_free_balancing, i64 %47) #17
  %179 = icmp eq i32 %178, 0
  br i1 %179, label %223, label %180

180:
  %181 = fadd double %93, %99
  br i1 %48, label %182, label %223

182:
  br i1 %60, label %211, label %183

183:
  %184 = phi i64 [ %207, %183 ], [ 0, %182 ]
  %185 = phi i64 [ %208, %183 ], [ 0, %182 ]
  %186 = shl nsw i64 %184, 3
  %187 = getelementptr inbounds i8, ptr @pp_balancing, i64 %186
  %188 = load i32, ptr %187, align 4
  %189 = zext i32 %188 to i64
  %190 = getelementptr inbounds double, ptr %9, i64 %189
  %191 = load double, ptr %190, align 8
  %192 = fmul double %99, %191
  %193 = getelementptr inbounds double, ptr %13, i64 %184
  %194 = load double, ptr %193, align 8
  %195 = fadd double %194, %192
  store double %195, ptr %193, align 8
  %196 = or i64 %184, 1
  %197 = shl nsw i64 %196, 3
  %198 = getelementptr inbounds i8, ptr @pp_balancing, i64 %197
  %199 = load i32, ptr %198, align 4
  %200 = zext i32 %199 to i64
  %201 = getelementptr inbounds double, ptr %9, i64 %200
  %202 = load double, ptr %201, align 8
  %203 = fmul double %99, %202
  %204 = getelementptr inbounds double, ptr %13, i64 %196
  %205 = load double, ptr %204, align 8
  %206 = fadd double %205, %203
  store double %206, ptr %204, align 8
  %207 = add nuw nsw i64 %184, 2
  %208 = add i64 %185, 2
  %209 = icmp eq i64 %208, %61
  br i1 %209, label %210, label %183

210:
  br i1 %62, label %223, label %211

211:
  %212 = phi i64 [ 0, %182 ], [ %207, %210 ]
  tail call void @llvm.assume(i1 %63)
  %213 = shl nsw i64 %212, 3
  %214 = getelementptr inbounds i8, ptr @pp_balancing, i64 %213
  %215 = load i32, ptr %214, align 4
  %216 = zext i32 %215 to i64
  %217 = getelementptr inbounds double, ptr %9, i64 %216
  %218 = load double, ptr %217, align 8
  %219 = fmul double %99, %218
  %220 = getelementptr inbounds double, ptr %13, i64 %212
  %221 = load double, ptr %220, align 8
  %222 = fadd double %221, %219
  store double %222, ptr %220, align 8
  br label %223

223:
  %224 = phi double [ %93, %177 ], [ %93, %92 ], [ %181, %180 ], [ %181, %210 ], [ %181, %211 ]
  %225 = add nuw nsw i64 %94, 1
  %226 = icmp slt i64 %225, %41
  br i1 %226, label %92, label %85

227:
  %228 = icmp eq i64 %88, 0
  br i1 %228, label %241, label %229

229:
  %230 = phi i64 [ 0, %87 ], [ %266, %227 ]
  %231 = icmp ne i64 %88, 0
  tail call void @llvm.assume(i1 %231)
  br label %232

232:
  %233 = phi i64 [ %238, %232 ], [ %230, %229 ]
  %234 = phi i64 [ %239, %232 ], [ 0, %229 ]
  %235 = getelementptr inbounds double, ptr %12, i64 %233
  %236 = load double, ptr %235, align 8
  %237 = getelementptr inbounds double, ptr %5, i64 %233
  store double %236, ptr %237, align 8
  %238 = add nuw nsw i64 %233, 1
  %239 = add i64 %234, 1
  %240 = icmp eq i64 %239, %88
  br i1 %240, label %241, label %232

241:
  %242 = fcmp ogt double %86, 0.000000e+00
  %243 = select i1 %18, i1 %242, i1 false
  %244 = icmp sgt i64 %3, 0
  %245 = and i1 %243, %244
  br i1 %245, label %246, label %285

246:
  %247 = getelementptr inbounds i8, ptr %0, i64 104
  br label %269

248:
  %249 = phi i64 [ 0, %90 ], [ %266, %248 ]
  %250 = phi i64 [ 0, %90 ], [ %267, %248 ]
  %251 = getelementptr inbounds double, ptr %12, i64 %249
  %252 = load double, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %5, i64 %249
  store double %252, ptr %253, align 8
  %254 = or i64 %249, 1
  %255 = getelementptr inbounds double, ptr %12, i64 %254
  %256 = load double, ptr %255, align 8
  %257 = getelementptr inbounds double, ptr %5, i64 %254
  store double %256, ptr %257, align 8
  %258 = or i64 %249, 2
  %259 = getelementptr inbounds double, ptr %12, i64 %258
  %260 = load double, ptr %259, align 8
  %261 = getelementptr inbounds double, ptr %5, i64 %258
  store double %260, ptr %261, align 8
  %262 = or i64 %249, 3
  %263 = getelementptr inbounds double, ptr %12, i64 %262
  %264 = load double, ptr %263, align 8
  %265 = getelementptr inbounds double, ptr %5, i64 %262
  store double %264, ptr %265, align 8
  %266 = add nuw nsw i64 %249, 4
  %267 = add i64 %250, 4
  %268 = icmp eq i64 %267, %91
  br i1 %268, label %227, label %248

269:
  %270 = phi i64 [ 0, %246 ], [ %283, %269 ]
  %271 = shl nuw nsw i64 %270, 3
  %272 = getelementptr inbounds i8, ptr @pp_balancing, i64 %271
  %273 = getelementptr inbounds i8, ptr %272, i64 4
  %274 = load i32, ptr %273, align 4
  %275 = zext i32 %274 to i64
  %276 = getelementptr inbounds double, ptr %13, i64 %270
  %277 = load double, ptr %276, align 8
  %278 = fdiv double %277, %86
  %279 = load ptr, ptr %247, align 8
  %280 = getelementptr inbounds double, ptr %279, i64 %275
  %281 = load double, ptr %280, align 8
  %282 = fadd double %278, %281
  store double %282, ptr %280, align 8
  tail call fastcc void @put(ptr %0, i64 %275) #17
  %283 = add nuw nsw i64 %270, 1
  %284 = icmp slt i64 %283, %3
  br i1 %284, label %269, label %285

285:
  tail call fastcc void @release(ptr %0, ptr %12) #17
  %286 = zext i1 %243 to i32
  br label %287

287:
  %288 = phi i32 [ 0, %1 ], [ %286, %285 ]
  ret i32 %288
}

define internal fastcc i32 @settle(ptr %0, ptr %1, i64 %2) unnamed_addr #1 {
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %5 = shl nsw i64 %2, 1
  %6 = add i64 %5, 6
  %7 = mul i64 %6, %2
  %8 = shl i64 %4, 4
  %9 = shl i64 %7, 3
  %10 = add i64 %8, %9
  %11 = tail call fastcc ptr @allocate(ptr %0, i64 %10) #17
  %12 = icmp eq ptr %11, null
  br i1 %12, label %733, label %13

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
  %24 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %25 = tail call fastcc ptr @reals(ptr %0, i64 %24) #17
  %26 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 144), align 8
  %27 = tail call fastcc ptr @reals(ptr %0, i64 %26) #17
  %28 = icmp sgt i64 %4, 0
  br i1 %28, label %29, label %31

29:
  %30 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  br label %39

31:
  %32 = icmp sgt i64 %2, 0
  br i1 %32, label %33, label %49

33:
  %34 = add nsw i64 %2, -1
  %35 = and i64 %2, 3
  %36 = icmp ult i64 %34, 3
  br i1 %36, label %53, label %37

37:
  %38 = and i64 %2, 9223372036854775804
  br label %68

39:
  %40 = phi i64 [ 0, %29 ], [ %47, %39 ]
  %41 = getelementptr inbounds i64, ptr %22, i64 %40
  store i64 -1, ptr %41, align 8
  %42 = getelementptr inbounds double, ptr %25, i64 %40
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds double, ptr %21, i64 %40
  store double %43, ptr %44, align 8
  store double 0.000000e+00, ptr %42, align 8
  %45 = tail call fastcc ptr @reals(ptr %0, i64 %30) #17
  %46 = getelementptr inbounds double, ptr %45, i64 %40
  store double 0.000000e+00, ptr %46, align 8
  %47 = add nuw nsw i64 %40, 1
  %48 = icmp eq i64 %47, %4
  br i1 %48, label %31, label %39

49:
  %50 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br label %93

51:
  %52 = icmp eq i64 %35, 0
  br i1 %52, label %66, label %53

53:
  %54 = phi i64 [ 0, %33 ], [ %90, %51 ]
  %55 = icmp ne i64 %35, 0
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
  %65 = icmp eq i64 %64, %35
  br i1 %65, label %66, label %56

66:
  %67 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br label %101

68:
  %69 = phi i64 [ 0, %37 ], [ %90, %68 ]
  %70 = phi i64 [ 0, %37 ], [ %91, %68 ]
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
  %92 = icmp eq i64 %91, %38
  br i1 %92, label %51, label %68

93:
  %94 = phi i64 [ %50, %49 ], [ %67, %101 ]
  %95 = phi double [ 0.000000e+00, %49 ], [ %111, %101 ]
  br i1 %28, label %96, label %128

96:
  %97 = and i64 %4, 3
  %98 = icmp ult i64 %4, 4
  br i1 %98, label %116, label %99

99:
  %100 = and i64 %4, 9223372036854775804
  br label %130

101:
  %102 = phi double [ %111, %101 ], [ 0.000000e+00, %66 ]
  %103 = phi i64 [ %112, %101 ], [ 0, %66 ]
  %104 = getelementptr inbounds i32, ptr %1, i64 %103
  %105 = load i32, ptr %104, align 4
  %106 = zext i32 %105 to i64
  %107 = getelementptr inbounds double, ptr %27, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = tail call fastcc double @size_of(double %108) #17
  %110 = fcmp ogt double %109, %102
  %111 = select i1 %110, double %109, double %102
  %112 = add nuw nsw i64 %103, 1
  %113 = icmp eq i64 %112, %2
  br i1 %113, label %93, label %101

114:
  %115 = icmp eq i64 %97, 0
  br i1 %115, label %128, label %116

116:
  %117 = phi i64 [ 0, %96 ], [ %148, %114 ]
  %118 = icmp ne i64 %97, 0
  tail call void @llvm.assume(i1 %118)
  br label %119

119:
  %120 = phi i64 [ %125, %119 ], [ %117, %116 ]
  %121 = phi i64 [ %126, %119 ], [ 0, %116 ]
  %122 = getelementptr inbounds double, ptr %21, i64 %120
  %123 = load double, ptr %122, align 8
  %124 = getelementptr inbounds double, ptr %25, i64 %120
  store double %123, ptr %124, align 8
  %125 = add nuw nsw i64 %120, 1
  %126 = add i64 %121, 1
  %127 = icmp eq i64 %126, %97
  br i1 %127, label %128, label %119

128:
  %129 = icmp eq i64 %94, 1
  br i1 %129, label %151, label %154

130:
  %131 = phi i64 [ 0, %99 ], [ %148, %130 ]
  %132 = phi i64 [ 0, %99 ], [ %149, %130 ]
  %133 = getelementptr inbounds double, ptr %21, i64 %131
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %25, i64 %131
  store double %134, ptr %135, align 8
  %136 = or i64 %131, 1
  %137 = getelementptr inbounds double, ptr %21, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = getelementptr inbounds double, ptr %25, i64 %136
  store double %138, ptr %139, align 8
  %140 = or i64 %131, 2
  %141 = getelementptr inbounds double, ptr %21, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %25, i64 %140
  store double %142, ptr %143, align 8
  %144 = or i64 %131, 3
  %145 = getelementptr inbounds double, ptr %21, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = getelementptr inbounds double, ptr %25, i64 %144
  store double %146, ptr %147, align 8
  %148 = add nuw nsw i64 %131, 4
  %149 = add i64 %132, 4
  %150 = icmp eq i64 %149, %100
  br i1 %150, label %114, label %130

151:
  %152 = tail call fastcc i64 @residual(ptr %0, i32 1, double 1.000000e+00, double 0.000000e+00) #17
  %153 = icmp eq i64 %152, 1
  br label %154

154:
  %155 = phi i1 [ %153, %151 ], [ false, %128 ]
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %32, label %156, label %178

156:
  %157 = add nuw i64 %2, 1
  %158 = add nsw i64 %2, -1
  %159 = and i64 %2, 3
  %160 = icmp ult i64 %158, 3
  br i1 %160, label %165, label %161

161:
  %162 = and i64 %2, 9223372036854775804
  br label %227

163:
  %164 = icmp eq i64 %159, 0
  br i1 %164, label %178, label %165

165:
  %166 = phi i64 [ 0, %156 ], [ %249, %163 ]
  %167 = icmp ne i64 %159, 0
  tail call void @llvm.assume(i1 %167)
  br label %168

168:
  %169 = phi i64 [ %166, %165 ], [ %175, %168 ]
  %170 = phi i64 [ 0, %165 ], [ %176, %168 ]
  %171 = mul i64 %169, %157
  %172 = getelementptr inbounds double, ptr %11, i64 %171
  %173 = load double, ptr %172, align 8
  %174 = getelementptr inbounds double, ptr %18, i64 %169
  store double %173, ptr %174, align 8
  %175 = add nuw nsw i64 %169, 1
  %176 = add i64 %170, 1
  %177 = icmp eq i64 %176, %159
  br i1 %177, label %178, label %168

178:
  br i1 %155, label %179, label %690

179:
  %180 = fmul double %95, 0x3D719799812DEA11
  %181 = icmp eq i64 %2, 0
  %182 = shl i64 %14, 3
  %183 = icmp slt i64 %2, 1
  %184 = tail call i64 @llvm.umax.i64(i64 %14, i64 1)
  %185 = add i64 %184, -1
  %186 = add i64 %2, -1
  %187 = and i64 %184, 1
  %188 = icmp ult i64 %14, 4
  %189 = and i64 %184, -4
  %190 = icmp eq i64 %187, 0
  %191 = icmp ne i64 %187, 0
  %192 = and i64 %184, 1
  %193 = icmp eq i64 %185, 0
  %194 = and i64 %184, -4
  %195 = icmp eq i64 %192, 0
  %196 = icmp ne i64 %192, 0
  %197 = and i64 %2, 3
  %198 = icmp ult i64 %186, 3
  %199 = and i64 %2, 9223372036854775804
  %200 = icmp eq i64 %197, 0
  %201 = icmp ne i64 %197, 0
  %202 = and i64 %184, 1
  %203 = icmp eq i64 %185, 0
  %204 = and i64 %184, -4
  %205 = icmp eq i64 %202, 0
  %206 = icmp ne i64 %202, 0
  %207 = and i64 %2, 3
  %208 = icmp ult i64 %186, 3
  %209 = and i64 %2, 9223372036854775804
  %210 = icmp eq i64 %207, 0
  %211 = icmp ne i64 %207, 0
  %212 = and i64 %2, 1
  %213 = icmp eq i64 %186, 0
  %214 = and i64 %2, 9223372036854775806
  %215 = icmp eq i64 %212, 0
  %216 = icmp ne i64 %212, 0
  %217 = and i64 %2, 3
  %218 = icmp ult i64 %186, 3
  %219 = and i64 %2, 9223372036854775804
  %220 = icmp eq i64 %217, 0
  %221 = icmp ne i64 %217, 0
  %222 = and i64 %2, 3
  %223 = icmp ult i64 %186, 3
  %224 = and i64 %2, 9223372036854775804
  %225 = icmp eq i64 %222, 0
  %226 = icmp ne i64 %222, 0
  br label %252

227:
  %228 = phi i64 [ 0, %161 ], [ %249, %227 ]
  %229 = phi i64 [ 0, %161 ], [ %250, %227 ]
  %230 = mul i64 %228, %157
  %231 = getelementptr inbounds double, ptr %11, i64 %230
  %232 = load double, ptr %231, align 8
  %233 = getelementptr inbounds double, ptr %18, i64 %228
  store double %232, ptr %233, align 8
  %234 = or i64 %228, 1
  %235 = mul i64 %234, %157
  %236 = getelementptr inbounds double, ptr %11, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = getelementptr inbounds double, ptr %18, i64 %234
  store double %237, ptr %238, align 8
  %239 = or i64 %228, 2
  %240 = mul i64 %239, %157
  %241 = getelementptr inbounds double, ptr %11, i64 %240
  %242 = load double, ptr %241, align 8
  %243 = getelementptr inbounds double, ptr %18, i64 %239
  store double %242, ptr %243, align 8
  %244 = or i64 %228, 3
  %245 = mul i64 %244, %157
  %246 = getelementptr inbounds double, ptr %11, i64 %245
  %247 = load double, ptr %246, align 8
  %248 = getelementptr inbounds double, ptr %18, i64 %244
  store double %247, ptr %248, align 8
  %249 = add nuw nsw i64 %228, 4
  %250 = add i64 %229, 4
  %251 = icmp eq i64 %250, %162
  br i1 %251, label %163, label %227

252:
  %253 = phi i64 [ 0, %179 ], [ %686, %685 ]
  %254 = phi i32 [ 1, %179 ], [ %627, %685 ]
  %255 = phi double [ 1.000000e+04, %179 ], [ %634, %685 ]
  %256 = icmp eq i32 %254, 0
  br i1 %256, label %411, label %257

257:
  %258 = tail call fastcc i64 @residual(ptr %0, i32 1, double 0.000000e+00, double 1.000000e+00) #17
  %259 = icmp eq i64 %258, 1
  br i1 %259, label %260, label %690

260:
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %32, label %261, label %731

261:
  %262 = phi i64 [ %282, %268 ], [ 1, %260 ]
  %263 = phi i64 [ %283, %268 ], [ 0, %260 ]
  %264 = mul nuw nsw i64 %263, %2
  %265 = getelementptr double, ptr %11, i64 %264
  br label %285

266:
  %267 = icmp eq i64 %282, 0
  br i1 %267, label %302, label %731

268:
  %269 = fmul double %299, 1.800000e-15
  %270 = fcmp ogt double %269, %180
  %271 = select i1 %270, double %269, double %180
  %272 = getelementptr inbounds double, ptr %20, i64 %263
  store double %271, ptr %272, align 8
  %273 = getelementptr inbounds i32, ptr %1, i64 %263
  %274 = load i32, ptr %273, align 4
  %275 = zext i32 %274 to i64
  %276 = getelementptr inbounds double, ptr %27, i64 %275
  %277 = load double, ptr %276, align 8
  %278 = getelementptr inbounds double, ptr %17, i64 %263
  store double %277, ptr %278, align 8
  %279 = tail call fastcc double @size_of(double %277) #17
  %280 = load double, ptr %272, align 8
  %281 = fcmp ugt double %279, %280
  %282 = select i1 %281, i64 0, i64 %262
  %283 = add nuw nsw i64 %263, 1
  %284 = icmp eq i64 %283, %2
  br i1 %284, label %266, label %261

285:
  %286 = phi i64 [ 0, %261 ], [ %300, %285 ]
  %287 = phi double [ 0.000000e+00, %261 ], [ %299, %285 ]
  %288 = getelementptr double, ptr %265, i64 %286
  %289 = load double, ptr %288, align 8
  %290 = tail call fastcc double @size_of(double %289) #17
  %291 = getelementptr inbounds i32, ptr %1, i64 %286
  %292 = load i32, ptr %291, align 4
  %293 = zext i32 %292 to i64
  %294 = getelementptr inbounds double, ptr %25, i64 %293
  %295 = load double, ptr %294, align 8
  %296 = tail call fastcc double @size_of(double %295) #17
  %297 = fadd double %296, 1.000000e+00
  %298 = fmul double %290, %297
  %299 = fadd double %287, %298
  %300 = add nuw nsw i64 %286, 1
  %301 = icmp eq i64 %300, %2
  br i1 %301, label %268, label %285

302:
  %303 = tail call fastcc i64 @residual(ptr %0, i32 1, double 1.000000e+00, double 0.000000e+00) #17
  %304 = icmp eq i64 %303, 1
  br i1 %304, label %305, label %690

305:
  br i1 %188, label %307, label %319

306:
  br i1 %190, label %318, label %307

307:
  %308 = phi i64 [ 0, %305 ], [ %337, %306 ]
  tail call void @llvm.assume(i1 %191)
  br label %309

309:
  %310 = phi i64 [ %315, %309 ], [ %308, %307 ]
  %311 = phi i64 [ %316, %309 ], [ 0, %307 ]
  %312 = getelementptr inbounds double, ptr %11, i64 %310
  %313 = load double, ptr %312, align 8
  %314 = getelementptr inbounds double, ptr %15, i64 %310
  store double %313, ptr %314, align 8
  %315 = add nuw nsw i64 %310, 1
  %316 = add i64 %311, 1
  %317 = icmp eq i64 %311, 0
  br i1 %317, label %318, label %309

318:
  tail call fastcc void @gather(ptr %0, ptr %22, i64 %2, ptr %11) #17
  br i1 %193, label %356, label %340

319:
  %320 = phi i64 [ %337, %319 ], [ 0, %305 ]
  %321 = phi i64 [ %338, %319 ], [ 0, %305 ]
  %322 = getelementptr inbounds double, ptr %11, i64 %320
  %323 = load double, ptr %322, align 8
  %324 = getelementptr inbounds double, ptr %15, i64 %320
  store double %323, ptr %324, align 8
  %325 = or i64 %320, 1
  %326 = getelementptr inbounds double, ptr %11, i64 %325
  %327 = load double, ptr %326, align 8
  %328 = getelementptr inbounds double, ptr %15, i64 %325
  store double %327, ptr %328, align 8
  %329 = or i64 %320, 2
  %330 = getelementptr inbounds double, ptr %11, i64 %329
  %331 = load double, ptr %330, align 8
  %332 = getelementptr inbounds double, ptr %15, i64 %329
  store double %331, ptr %332, align 8
  %333 = or i64 %320, 3
  %334 = getelementptr inbounds double, ptr %11, i64 %333
  %335 = load double, ptr %334, align 8
  %336 = getelementptr inbounds double, ptr %15, i64 %333
  store double %335, ptr %336, align 8
  %337 = add nuw nsw i64 %320, 4
  %338 = add i64 %321, 4
  %339 = icmp eq i64 %338, %189
  br i1 %339, label %306, label %319

340:
  %341 = phi i64 [ %352, %340 ], [ 0, %318 ]
  %342 = phi i64 [ %353, %340 ], [ 0, %318 ]
  %343 = getelementptr inbounds double, ptr %11, i64 %341
  %344 = load double, ptr %343, align 8
  %345 = getelementptr inbounds double, ptr %15, i64 %341
  %346 = load double, ptr %345, align 8
  store double %346, ptr %343, align 8
  store double %344, ptr %345, align 8
  %347 = or i64 %341, 1
  %348 = getelementptr inbounds double, ptr %11, i64 %347
  %349 = load double, ptr %348, align 8
  %350 = getelementptr inbounds double, ptr %15, i64 %347
  %351 = load double, ptr %350, align 8
  store double %351, ptr %348, align 8
  store double %349, ptr %350, align 8
  %352 = add nuw nsw i64 %341, 2
  %353 = add i64 %342, 2
  %354 = icmp eq i64 %353, %194
  br i1 %354, label %355, label %340

355:
  br i1 %195, label %362, label %356

356:
  %357 = phi i64 [ 0, %318 ], [ %352, %355 ]
  tail call void @llvm.assume(i1 %196)
  %358 = getelementptr inbounds double, ptr %11, i64 %357
  %359 = load double, ptr %358, align 8
  %360 = getelementptr inbounds double, ptr %15, i64 %357
  %361 = load double, ptr %360, align 8
  store double %361, ptr %358, align 8
  store double %359, ptr %360, align 8
  br label %362

362:
  br i1 %198, label %397, label %363

363:
  %364 = phi i64 [ %393, %363 ], [ 0, %362 ]
  %365 = phi i64 [ %394, %363 ], [ 0, %362 ]
  %366 = getelementptr inbounds i32, ptr %1, i64 %364
  %367 = load i32, ptr %366, align 4
  %368 = zext i32 %367 to i64
  %369 = getelementptr inbounds double, ptr %25, i64 %368
  %370 = load double, ptr %369, align 8
  %371 = getelementptr inbounds double, ptr %19, i64 %364
  store double %370, ptr %371, align 8
  %372 = or i64 %364, 1
  %373 = getelementptr inbounds i32, ptr %1, i64 %372
  %374 = load i32, ptr %373, align 4
  %375 = zext i32 %374 to i64
  %376 = getelementptr inbounds double, ptr %25, i64 %375
  %377 = load double, ptr %376, align 8
  %378 = getelementptr inbounds double, ptr %19, i64 %372
  store double %377, ptr %378, align 8
  %379 = or i64 %364, 2
  %380 = getelementptr inbounds i32, ptr %1, i64 %379
  %381 = load i32, ptr %380, align 4
  %382 = zext i32 %381 to i64
  %383 = getelementptr inbounds double, ptr %25, i64 %382
  %384 = load double, ptr %383, align 8
  %385 = getelementptr inbounds double, ptr %19, i64 %379
  store double %384, ptr %385, align 8
  %386 = or i64 %364, 3
  %387 = getelementptr inbounds i32, ptr %1, i64 %386
  %388 = load i32, ptr %387, align 4
  %389 = zext i32 %388 to i64
  %390 = getelementptr inbounds double, ptr %25, i64 %389
  %391 = load double, ptr %390, align 8
  %392 = getelementptr inbounds double, ptr %19, i64 %386
  store double %391, ptr %392, align 8
  %393 = add nuw nsw i64 %364, 4
  %394 = add i64 %365, 4
  %395 = icmp eq i64 %394, %199
  br i1 %395, label %396, label %363

396:
  br i1 %200, label %411, label %397

397:
  %398 = phi i64 [ 0, %362 ], [ %393, %396 ]
  tail call void @llvm.assume(i1 %201)
  br label %399

399:
  %400 = phi i64 [ %408, %399 ], [ %398, %397 ]
  %401 = phi i64 [ %409, %399 ], [ 0, %397 ]
  %402 = getelementptr inbounds i32, ptr %1, i64 %400
  %403 = load i32, ptr %402, align 4
  %404 = zext i32 %403 to i64
  %405 = getelementptr inbounds double, ptr %25, i64 %404
  %406 = load double, ptr %405, align 8
  %407 = getelementptr inbounds double, ptr %19, i64 %400
  store double %406, ptr %407, align 8
  %408 = add nuw nsw i64 %400, 1
  %409 = add i64 %401, 1
  %410 = icmp eq i64 %409, %197
  br i1 %410, label %411, label %399

411:
  %412 = tail call fastcc ptr @allocate(ptr %0, i64 %182) #17
  %413 = icmp eq ptr %412, null
  br i1 %413, label %690, label %414

414:
  br i1 %181, label %450, label %415

415:
  br i1 %203, label %417, label %429

416:
  br i1 %205, label %426, label %417

417:
  %418 = phi i64 [ 0, %415 ], [ %447, %416 ]
  tail call void @llvm.assume(i1 %206)
  %419 = getelementptr inbounds double, ptr %11, i64 %418
  %420 = load double, ptr %419, align 8
  %421 = getelementptr inbounds double, ptr %15, i64 %418
  %422 = load double, ptr %421, align 8
  %423 = fmul double %255, %422
  %424 = fadd double %420, %423
  %425 = getelementptr inbounds double, ptr %412, i64 %418
  store double %424, ptr %425, align 8
  br label %426

426:
  %427 = tail call fastcc i32 @factorise(ptr %412, i64 %2, ptr %23) #17
  br i1 %32, label %428, label %468

428:
  br i1 %208, label %454, label %470

429:
  %430 = phi i64 [ %447, %429 ], [ 0, %415 ]
  %431 = phi i64 [ %448, %429 ], [ 0, %415 ]
  %432 = getelementptr inbounds double, ptr %11, i64 %430
  %433 = load double, ptr %432, align 8
  %434 = getelementptr inbounds double, ptr %15, i64 %430
  %435 = load double, ptr %434, align 8
  %436 = fmul double %255, %435
  %437 = fadd double %433, %436
  %438 = getelementptr inbounds double, ptr %412, i64 %430
  store double %437, ptr %438, align 8
  %439 = or i64 %430, 1
  %440 = getelementptr inbounds double, ptr %11, i64 %439
  %441 = load double, ptr %440, align 8
  %442 = getelementptr inbounds double, ptr %15, i64 %439
  %443 = load double, ptr %442, align 8
  %444 = fmul double %255, %443
  %445 = fadd double %441, %444
  %446 = getelementptr inbounds double, ptr %412, i64 %439
  store double %445, ptr %446, align 8
  %447 = add nuw nsw i64 %430, 2
  %448 = add i64 %431, 2
  %449 = icmp eq i64 %448, %204
  br i1 %449, label %416, label %429

450:
  %451 = tail call fastcc i32 @factorise(ptr %412, i64 %2, ptr %23) #17
  %452 = icmp eq i32 %451, 0
  br i1 %452, label %626, label %496

453:
  br i1 %210, label %466, label %454

454:
  %455 = phi i64 [ 0, %428 ], [ %492, %453 ]
  tail call void @llvm.assume(i1 %211)
  br label %456

456:
  %457 = phi i64 [ %463, %456 ], [ %455, %454 ]
  %458 = phi i64 [ %464, %456 ], [ 0, %454 ]
  %459 = getelementptr inbounds double, ptr %17, i64 %457
  %460 = load double, ptr %459, align 8
  %461 = fneg double %460
  %462 = getelementptr inbounds double, ptr %16, i64 %457
  store double %461, ptr %462, align 8
  %463 = add nuw nsw i64 %457, 1
  %464 = add i64 %458, 1
  %465 = icmp eq i64 %464, %207
  br i1 %465, label %466, label %456

466:
  %467 = icmp eq i32 %427, 0
  br i1 %467, label %626, label %495

468:
  %469 = icmp eq i32 %427, 0
  br i1 %469, label %626, label %496

470:
  %471 = phi i64 [ %492, %470 ], [ 0, %428 ]
  %472 = phi i64 [ %493, %470 ], [ 0, %428 ]
  %473 = getelementptr inbounds double, ptr %17, i64 %471
  %474 = load double, ptr %473, align 8
  %475 = fneg double %474
  %476 = getelementptr inbounds double, ptr %16, i64 %471
  store double %475, ptr %476, align 8
  %477 = or i64 %471, 1
  %478 = getelementptr inbounds double, ptr %17, i64 %477
  %479 = load double, ptr %478, align 8
  %480 = fneg double %479
  %481 = getelementptr inbounds double, ptr %16, i64 %477
  store double %480, ptr %481, align 8
  %482 = or i64 %471, 2
  %483 = getelementptr inbounds double, ptr %17, i64 %482
  %484 = load double, ptr %483, align 8
  %485 = fneg double %484
  %486 = getelementptr inbounds double, ptr %16, i64 %482
  store double %485, ptr %486, align 8
  %487 = or i64 %471, 3
  %488 = getelementptr inbounds double, ptr %17, i64 %487
  %489 = load double, ptr %488, align 8
  %490 = fneg double %489
  %491 = getelementptr inbounds double, ptr %16, i64 %487
  store double %490, ptr %491, align 8
  %492 = add nuw nsw i64 %471, 4
  %493 = add i64 %472, 4
  %494 = icmp eq i64 %493, %209
  br i1 %494, label %453, label %470

495:
  tail call fastcc void @solve(ptr %412, i64 %2, ptr %23, ptr %16) #17
  br i1 %213, label %499, label %512

496:
  tail call fastcc void @solve(ptr %412, i64 %2, ptr %23, ptr %16) #17
  %497 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br label %552

498:
  br i1 %215, label %510, label %499

499:
  %500 = phi i64 [ 0, %495 ], [ %534, %498 ]
  tail call void @llvm.assume(i1 %216)
  %501 = getelementptr inbounds double, ptr %19, i64 %500
  %502 = load double, ptr %501, align 8
  %503 = getelementptr inbounds double, ptr %16, i64 %500
  %504 = load double, ptr %503, align 8
  %505 = fadd double %502, %504
  %506 = getelementptr inbounds i32, ptr %1, i64 %500
  %507 = load i32, ptr %506, align 4
  %508 = zext i32 %507 to i64
  %509 = getelementptr inbounds double, ptr %25, i64 %508
  store double %505, ptr %509, align 8
  br label %510

510:
  %511 = tail call fastcc i64 @residual(ptr %0, i32 0, double 0.000000e+00, double 0.000000e+00) #17
  br i1 %218, label %538, label %555

512:
  %513 = phi i64 [ %534, %512 ], [ 0, %495 ]
  %514 = phi i64 [ %535, %512 ], [ 0, %495 ]
  %515 = getelementptr inbounds double, ptr %19, i64 %513
  %516 = load double, ptr %515, align 8
  %517 = getelementptr inbounds double, ptr %16, i64 %513
  %518 = load double, ptr %517, align 8
  %519 = fadd double %516, %518
  %520 = getelementptr inbounds i32, ptr %1, i64 %513
  %521 = load i32, ptr %520, align 4
  %522 = zext i32 %521 to i64
  %523 = getelementptr inbounds double, ptr %25, i64 %522
  store double %519, ptr %523, align 8
  %524 = or i64 %513, 1
  %525 = getelementptr inbounds double, ptr %19, i64 %524
  %526 = load double, ptr %525, align 8
  %527 = getelementptr inbounds double, ptr %16, i64 %524
  %528 = load double, ptr %527, align 8
  %529 = fadd double %526, %528
  %530 = getelementptr inbounds i32, ptr %1, i64 %524
  %531 = load i32, ptr %530, align 4
  %532 = zext i32 %531 to i64
  %533 = getelementptr inbounds double, ptr %25, i64 %532
  store double %529, ptr %533, align 8
  %534 = add nuw nsw i64 %513, 2
  %535 = add i64 %514, 2
  %536 = icmp eq i64 %535, %214
  br i1 %536, label %498, label %512

537:
  br i1 %220, label %552, label %538

538:
  %539 = phi i64 [ 0, %510 ], [ %585, %537 ]
  tail call void @llvm.assume(i1 %221)
  br label %540

540:
  %541 = phi i64 [ %549, %540 ], [ %539, %538 ]
  %542 = phi i64 [ %550, %540 ], [ 0, %538 ]
  %543 = getelementptr inbounds i32, ptr %1, i64 %541
  %544 = load i32, ptr %543, align 4
  %545 = zext i32 %544 to i64
  %546 = getelementptr inbounds double, ptr %27, i64 %545
  %547 = load double, ptr %546, align 8
  %548 = getelementptr inbounds double, ptr %20, i64 %541
  store double %547, ptr %548, align 8
  %549 = add nuw nsw i64 %541, 1
  %550 = add i64 %542, 1
  %551 = icmp eq i64 %550, %217
  br i1 %551, label %552, label %540

552:
  %553 = phi i64 [ %497, %496 ], [ %511, %540 ], [ %511, %537 ]
  %554 = icmp eq i64 %553, 1
  br i1 %554, label %588, label %626

555:
  %556 = phi i64 [ %585, %555 ], [ 0, %510 ]
  %557 = phi i64 [ %586, %555 ], [ 0, %510 ]
  %558 = getelementptr inbounds i32, ptr %1, i64 %556
  %559 = load i32, ptr %558, align 4
  %560 = zext i32 %559 to i64
  %561 = getelementptr inbounds double, ptr %27, i64 %560
  %562 = load double, ptr %561, align 8
  %563 = getelementptr inbounds double, ptr %20, i64 %556
  store double %562, ptr %563, align 8
  %564 = or i64 %556, 1
  %565 = getelementptr inbounds i32, ptr %1, i64 %564
  %566 = load i32, ptr %565, align 4
  %567 = zext i32 %566 to i64
  %568 = getelementptr inbounds double, ptr %27, i64 %567
  %569 = load double, ptr %568, align 8
  %570 = getelementptr inbounds double, ptr %20, i64 %564
  store double %569, ptr %570, align 8
  %571 = or i64 %556, 2
  %572 = getelementptr inbounds i32, ptr %1, i64 %571
  %573 = load i32, ptr %572, align 4
  %574 = zext i32 %573 to i64
  %575 = getelementptr inbounds double, ptr %27, i64 %574
  %576 = load double, ptr %575, align 8
  %577 = getelementptr inbounds double, ptr %20, i64 %571
  store double %576, ptr %577, align 8
  %578 = or i64 %556, 3
  %579 = getelementptr inbounds i32, ptr %1, i64 %578
  %580 = load i32, ptr %579, align 4
  %581 = zext i32 %580 to i64
  %582 = getelementptr inbounds double, ptr %27, i64 %581
  %583 = load double, ptr %582, align 8
  %584 = getelementptr inbounds double, ptr %20, i64 %578
  store double %583, ptr %584, align 8
  %585 = add nuw nsw i64 %556, 4
  %586 = add i64 %557, 4
  %587 = icmp eq i64 %586, %219
  br i1 %587, label %537, label %555

588:
  %589 = tail call fastcc i32 @all_finite(ptr %20, i64 %2) #17
  %590 = icmp eq i32 %589, 0
  br i1 %590, label %626, label %591

591:
  br i1 %32, label %601, label %594

592:
  %593 = fcmp ule double %610, 0.000000e+00
  br label %594

594:
  %595 = phi i1 [ true, %591 ], [ %593, %592 ]
  %596 = phi double [ 0.000000e+00, %591 ], [ %613, %592 ]
  tail call fastcc void @solve(ptr %412, i64 %2, ptr %23, ptr %20) #17
  %597 = tail call fastcc double @length_of(ptr %20, ptr %18, i64 %2) #17
  %598 = tail call fastcc double @length_of(ptr %16, ptr %18, i64 %2) #17
  %599 = fdiv double %597, %598
  %600 = fcmp olt double %599, 8.100000e-01
  br i1 %600, label %622, label %616

601:
  %602 = phi i64 [ %614, %601 ], [ 0, %591 ]
  %603 = phi double [ %613, %601 ], [ 0.000000e+00, %591 ]
  %604 = phi double [ %610, %601 ], [ 0.000000e+00, %591 ]
  %605 = getelementptr inbounds double, ptr %20, i64 %602
  %606 = load double, ptr %605, align 8
  %607 = getelementptr inbounds double, ptr %16, i64 %602
  %608 = load double, ptr %607, align 8
  %609 = fmul double %606, %608
  %610 = fadd double %604, %609
  %611 = tail call fastcc double @size_of(double %606) #17
  %612 = fcmp ogt double %611, %603
  %613 = select i1 %612, double %611, double %603
  %614 = add nuw nsw i64 %602, 1
  %615 = icmp eq i64 %614, %2
  br i1 %615, label %592, label %601

616:
  %617 = fcmp ole double %596, %95
  %618 = select i1 %617, double 4.000000e+00, double 1.020000e+00
  %619 = fcmp ole double %599, %618
  %620 = select i1 %619, i1 %595, i1 false
  %621 = zext i1 %620 to i32
  br label %622

622:
  %623 = phi i32 [ 1, %594 ], [ %621, %616 ]
  %624 = fcmp olt double %599, 2.500000e-01
  %625 = select i1 %624, double 1.000000e-01, double 5.000000e-01
  br label %626

626:
  %627 = phi i32 [ 0, %450 ], [ %623, %622 ], [ 0, %588 ], [ 0, %552 ], [ 0, %468 ], [ 0, %466 ]
  %628 = phi double [ 5.000000e-01, %450 ], [ %625, %622 ], [ 5.000000e-01, %588 ], [ 5.000000e-01, %552 ], [ 5.000000e-01, %468 ], [ 5.000000e-01, %466 ]
  tail call fastcc void @release(ptr %0, ptr %412) #17
  %629 = icmp ne i32 %627, 0
  %630 = select i1 %629, double %628, double 8.000000e+00
  %631 = fmul double %255, %630
  %632 = fcmp olt double %631, 1.000000e-03
  %633 = select i1 %629, i1 %632, i1 false
  %634 = select i1 %633, double 1.000000e-03, double %631
  %635 = or i1 %629, %183
  br i1 %635, label %685, label %636

636:
  br i1 %223, label %671, label %637

637:
  %638 = phi i64 [ %667, %637 ], [ 0, %636 ]
  %639 = phi i64 [ %668, %637 ], [ 0, %636 ]
  %640 = getelementptr inbounds double, ptr %19, i64 %638
  %641 = load double, ptr %640, align 8
  %642 = getelementptr inbounds i32, ptr %1, i64 %638
  %643 = load i32, ptr %642, align 4
  %644 = zext i32 %643 to i64
  %645 = getelementptr inbounds double, ptr %25, i64 %644
  store double %641, ptr %645, align 8
  %646 = or i64 %638, 1
  %647 = getelementptr inbounds double, ptr %19, i64 %646
  %648 = load double, ptr %647, align 8
  %649 = getelementptr inbounds i32, ptr %1, i64 %646
  %650 = load i32, ptr %649, align 4
  %651 = zext i32 %650 to i64
  %652 = getelementptr inbounds double, ptr %25, i64 %651
  store double %648, ptr %652, align 8
  %653 = or i64 %638, 2
  %654 = getelementptr inbounds double, ptr %19, i64 %653
  %655 = load double, ptr %654, align 8
  %656 = getelementptr inbounds i32, ptr %1, i64 %653
  %657 = load i32, ptr %656, align 4
  %658 = zext i32 %657 to i64
  %659 = getelementptr inbounds double, ptr %25, i64 %658
  store double %655, ptr %659, align 8
  %660 = or i64 %638, 3
  %661 = getelementptr inbounds double, ptr %19, i64 %660
  %662 = load double, ptr %661, align 8
  %663 = getelementptr inbounds i32, ptr %1, i64 %660
  %664 = load i32, ptr %663, align 4
  %665 = zext i32 %664 to i64
  %666 = getelementptr inbounds double, ptr %25, i64 %665
  store double %662, ptr %666, align 8
  %667 = add nuw nsw i64 %638, 4
  %668 = add i64 %639, 4
  %669 = icmp eq i64 %668, %224
  br i1 %669, label %670, label %637

670:
  br i1 %225, label %685, label %671

671:
  %672 = phi i64 [ 0, %636 ], [ %667, %670 ]
  tail call void @llvm.assume(i1 %226)
  br label %673

673:
  %674 = phi i64 [ %682, %673 ], [ %672, %671 ]
  %675 = phi i64 [ %683, %673 ], [ 0, %671 ]
  %676 = getelementptr inbounds double, ptr %19, i64 %674
  %677 = load double, ptr %676, align 8
  %678 = getelementptr inbounds i32, ptr %1, i64 %674
  %679 = load i32, ptr %678, align 4
  %680 = zext i32 %679 to i64
  %681 = getelementptr inbounds double, ptr %25, i64 %680
  store double %677, ptr %681, align 8
  %682 = add nuw nsw i64 %674, 1
  %683 = add i64 %675, 1
  %684 = icmp eq i64 %683, %222
  br i1 %684, label %685, label %673

685:
  %686 = add nuw nsw i64 %253, 1
  %687 = icmp ult i64 %253, 199
  %688 = fcmp olt double %634, 1.000000e+20
  %689 = select i1 %687, i1 %688, i1 false
  br i1 %689, label %252, label %690

690:
  br i1 %28, label %691, label %731

691:
  %692 = and i64 %4, 3
  %693 = icmp ult i64 %4, 4
  br i1 %693, label %719, label %694

694:
  %695 = and i64 %4, 9223372036854775804
  br label %696

696:
  %697 = phi i64 [ 0, %694 ], [ %714, %696 ]
  %698 = phi i64 [ 0, %694 ], [ %715, %696 ]
  %699 = getelementptr inbounds double, ptr %21, i64 %697
  %700 = load double, ptr %699, align 8
  %701 = getelementptr inbounds double, ptr %25, i64 %697
  store double %700, ptr %701, align 8
  %702 = or i64 %697, 1
  %703 = getelementptr inbounds double, ptr %21, i64 %702
  %704 = load double, ptr %703, align 8
  %705 = getelementptr inbounds double, ptr %25, i64 %702
  store double %704, ptr %705, align 8
  %706 = or i64 %697, 2
  %707 = getelementptr inbounds double, ptr %21, i64 %706
  %708 = load double, ptr %707, align 8
  %709 = getelementptr inbounds double, ptr %25, i64 %706
  store double %708, ptr %709, align 8
  %710 = or i64 %697, 3
  %711 = getelementptr inbounds double, ptr %21, i64 %710
  %712 = load double, ptr %711, align 8
  %713 = getelementptr inbounds double, ptr %25, i64 %710
  store double %712, ptr %713, align 8
  %714 = add nuw nsw i64 %697, 4
  %715 = add i64 %698, 4
  %716 = icmp eq i64 %715, %695
  br i1 %716, label %717, label %696

717:
  %718 = icmp eq i64 %692, 0
  br i1 %718, label %731, label %719

719:
  %720 = phi i64 [ 0, %691 ], [ %714, %717 ]
  %721 = icmp ne i64 %692, 0
  tail call void @llvm.assume(i1 %721)
  br label %722

722:
  %723 = phi i64 [ %728, %722 ], [ %720, %719 ]
  %724 = phi i64 [ %729, %722 ], [ 0, %719 ]
  %725 = getelementptr inbounds double, ptr %21, i64 %723
  %726 = load double, ptr %725, align 8
  %727 = getelementptr inbounds double, ptr %25, i64 %723
  store double %726, ptr %727, align 8
  %728 = add nuw nsw i64 %723, 1
  %729 = add i64 %724, 1
  %730 = icmp eq i64 %729, %692
  br i1 %730, label %731, label %722

731:
  %732 = phi i32 [ 0, %690 ], [ 0, %717 ], [ 0, %722 ], [ 1, %266 ], [ 1, %260 ]
  tail call fastcc void @release(ptr %0, ptr %11) #17
  br label %733

733:
  %734 = phi i32 [ %732, %731 ], [ 0, %3 ]
  ret i32 %734
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
  %16 = getelementptr inbounds i8, ptr %0, i64 112
  %17 = load ptr, ptr %16, align 8
  %18 = tail call fastcc i64 @address(ptr %17) #17
  %19 = tail call fastcc i64 @request(ptr %0, i64 2, i64 %18) #17
  %20 = icmp eq i64 %19, 1
  br i1 %20, label %21, label %26

21:
  %22 = load ptr, ptr %16, align 8
  %23 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 272), align 8
  %24 = tail call fastcc i32 @all_finite(ptr %22, i64 %23) #17
  %25 = icmp eq i32 %24, 0
  br i1 %25, label %26, label %28

26:
  %27 = phi i64 [ %13, %12 ], [ %19, %15 ], [ 4, %21 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.41, i64 %27, ptr @.str.42) #17
  br label %29

28:
  store i64 0, ptr %2, align 8
  br label %29

29:
  %30 = phi i32 [ 0, %28 ], [ 3, %26 ], [ 0, %1 ]
  ret i32 %30
}

define internal fastcc ptr @reals(ptr %0, i64 %1) unnamed_addr #4 {
  %3 = getelementptr inbounds i8, ptr %0, i64 128
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 %1
  ret ptr %5
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
  %4 = getelementptr inbounds i8, ptr %0, i64 104
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

define internal fastcc i64 @residual(ptr %0, i32 %1, double %2, double %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 128
  %6 = load ptr, ptr %5, align 8
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
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

define internal fastcc double @size_of(double %0) unnamed_addr #0 {
  %2 = fcmp olt double %0, 0.000000e+00
  %3 = fneg double %0
  %4 = select i1 %2, double %3, double %0
  ret double %4
}

define internal fastcc void @gather(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #11 {
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 152), align 8
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

define internal fastcc i64 @request(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = getelementptr inbounds i8, ptr %0, i64 88
  %5 = load i64, ptr %4, align 8
  %6 = icmp eq i64 %5, 0
  br i1 %6, label %8, label %7

7:
  tail call fastcc void @follow_inputs(ptr %0) #17
  br label %8

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 128
  %10 = load ptr, ptr %9, align 8
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
  %12 = getelementptr inbounds i8, ptr %10, i64 %11
  %13 = tail call fastcc double @now(ptr %0) #17
  store double %13, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %12, i64 32
  store i64 0, ptr %14, align 8
  %15 = getelementptr inbounds i8, ptr %12, i64 16
  store <2 x double> zeroinitializer, ptr %15, align 8
  %16 = icmp eq i64 %1, 4
  %17 = load double, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 352), align 8
  %18 = select i1 %16, double %17, double 0.000000e+00
  %19 = getelementptr inbounds i8, ptr %12, i64 8
  store double %18, ptr %19, align 8
  %20 = load ptr, ptr getelementptr inbounds (i8, ptr @pp_entries, i64 8), align 8
  %21 = tail call fastcc i64 @address(ptr %12) #17
  %22 = tail call i64 %20(i64 %21, i64 %1, i64 %2) #19
  ret i64 %22
}

define internal fastcc i64 @restart(ptr %0) unnamed_addr #1 {
  %2 = tail call fastcc i64 @request(ptr %0, i64 4, i64 0) #17
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 312), align 8
  %4 = icmp eq i64 %3, 0
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @rescale(ptr %0, double 0.000000e+00) #17
  br label %11

6:
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 168), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 288), align 8
  %10 = getelementptr inbounds double, ptr %8, i64 %9
  store double 0x7FF8000000000000, ptr %10, align 8
  br label %11

11:
  %12 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 176), align 8
  %13 = tail call fastcc ptr @integers(ptr %0, i64 %12) #17
  %14 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 304), align 8
  %15 = getelementptr inbounds i64, ptr %13, i64 %14
  store i64 0, ptr %15, align 8
  %16 = getelementptr inbounds i8, ptr %0, i64 72
  store i64 1, ptr %16, align 8
  ret i64 %2
}

define internal fastcc void @stop(ptr %0, ptr %1, i64 %2, ptr %3) unnamed_addr #1 {
  %5 = getelementptr inbounds i8, ptr %0, i64 80
  store i64 1, ptr %5, align 8
  %6 = getelementptr inbounds i8, ptr %0, i64 136
  store i8 0, ptr %6, align 8
  tail call fastcc void @append(ptr %0, ptr %1) #17
  %7 = icmp sgt i64 %2, -1
  %8 = load i64, ptr @pp_n_sentences, align 8
  %9 = icmp slt i64 %2, %8
  %10 = select i1 %7, i1 %9, i1 false
  br i1 %10, label %11, label %14

11:
  tail call fastcc void @append(ptr %0, ptr @.str.43) #17
  %12 = getelementptr inbounds ptr, ptr @pp_sentences, i64 %2
  %13 = load ptr, ptr %12, align 8
  tail call fastcc void @append(ptr %0, ptr %13) #17
  br label %14

14:
  tail call fastcc void @append(ptr %0, ptr @.str.44) #17
  tail call fastcc void @append(ptr %0, ptr %3) #17
  tail call fastcc void @fail(ptr %0, ptr %6) #17
  ret void
}

define internal fastcc void @follow_inputs(ptr %0) unnamed_addr #9 {
  %2 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %3 = icmp ne i64 %2, 0
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %5 = icmp sgt i64 %4, 0
  %6 = select i1 %3, i1 %5, i1 false
  br i1 %6, label %7, label %9

7:
  %8 = getelementptr inbounds i8, ptr %0, i64 104
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

define internal fastcc void @rescale(ptr %0, double %1) unnamed_addr #9 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %4 = tail call fastcc ptr @reals(ptr %0, i64 %3) #17
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 184), align 8
  %6 = tail call fastcc ptr @reals(ptr %0, i64 %5) #17
  %7 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 192), align 8
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 128), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 200), align 8
  %12 = tail call fastcc ptr @reals(ptr %0, i64 %11) #17
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %14 = icmp sgt i64 %13, 0
  br i1 %14, label %23, label %15

15:
  %16 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 264), align 8
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
  %53 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 176), align 8
  %54 = tail call fastcc ptr @integers(ptr %0, i64 %53) #17
  %55 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 304), align 8
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
  %3 = getelementptr inbounds i8, ptr %0, i64 128
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds i8, ptr %4, i64 %1
  ret ptr %5
}

define internal fastcc void @append(ptr %0, ptr %1) unnamed_addr #12 {
  %3 = getelementptr inbounds i8, ptr %0, i64 136
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
  %3 = getelementptr inbounds i8, ptr %0, i64 128
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
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %4 = icmp slt i64 %1, %3
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 104), align 8
  %6 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 112), align 8
  %7 = select i1 %4, i64 %5, i64 %6
  %8 = tail call fastcc ptr @reals(ptr %0, i64 %7) #17
  %9 = select i1 %4, i64 0, i64 %3
  %10 = sub nsw i64 %1, %9
  %11 = getelementptr inbounds double, ptr %8, i64 %10
  ret ptr %11
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
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %12 = icmp slt i64 %10, %11
  %13 = select i1 %12, double 1.000000e-08, double 1.000000e-04
  br label %24

14:
  %15 = getelementptr inbounds i8, ptr %0, i64 104
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %16, i64 %4
  %18 = load double, ptr %17, align 8
  %19 = fcmp olt double %18, 0.000000e+00
  %20 = fneg double %18
  %21 = select i1 %19, double %20, double %18
  %22 = fadd double %21, 1.000000e+00
  %23 = fmul double %22, 0x3EB0C6F7A0B5ED8D
  br label %24

24:
  %25 = phi double [ %13, %8 ], [ %23, %14 ]
  %26 = fcmp olt double %2, 0.000000e+00
  %27 = fneg double %2
  %28 = select i1 %26, double %27, double %2
  %29 = fdiv double %25, %28
  ret double %29
}

define internal fastcc i32 @add(ptr %0, ptr %1, i64 %2, ptr %3, double %4) unnamed_addr #1 {
  %6 = alloca double, align 8
  %7 = icmp eq i64 %2, 0
  br i1 %7, label %38, label %8

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 104
  %10 = getelementptr inbounds i8, ptr %0, i64 72
  br label %11

11:
  %12 = phi i64 [ 0, %8 ], [ %36, %35 ]
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
  br label %35

28:
  %29 = load ptr, ptr %9, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %15
  %31 = load double, ptr %30, align 8
  %32 = fadd double %19, %31
  store double %32, ptr %6, align 8
  %33 = call fastcc i32 @set_numbers(ptr %0, ptr %13, i64 1, ptr %6) #17
  %34 = icmp eq i32 %33, 0
  br i1 %34, label %35, label %38

35:
  %36 = add nuw i64 %12, 1
  %37 = icmp eq i64 %36, %2
  br i1 %37, label %38, label %11

38:
  %39 = phi i32 [ 0, %5 ], [ 0, %35 ], [ 3, %28 ]
  ret i32 %39
}

define internal fastcc void @change_step(ptr %0, double %1) unnamed_addr #9 {
  %3 = tail call fastcc double @now(ptr %0) #17
  %4 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 312), align 8
  %5 = icmp eq i64 %4, 0
  br i1 %5, label %10, label %6

6:
  %7 = getelementptr inbounds i8, ptr %0, i64 56
  %8 = load double, ptr %7, align 8
  %9 = fdiv double %1, %8
  tail call fastcc void @rescale(ptr %0, double %9) #17
  br label %15

10:
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 168), align 8
  %12 = tail call fastcc ptr @reals(ptr %0, i64 %11) #17
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 296), align 8
  %14 = getelementptr inbounds double, ptr %12, i64 %13
  store double 0.000000e+00, ptr %14, align 8
  br label %15

15:
  %16 = getelementptr inbounds i8, ptr %0, i64 48
  store double %3, ptr %16, align 8
  %17 = getelementptr inbounds i8, ptr %0, i64 64
  store i64 0, ptr %17, align 8
  %18 = getelementptr inbounds i8, ptr %0, i64 56
  store double %1, ptr %18, align 8
  ret void
}

define internal fastcc void @lead(ptr %0, double %1) unnamed_addr #9 {
  %3 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 40), align 8
  %4 = icmp ne i64 %3, 0
  %5 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 24), align 8
  %6 = icmp sgt i64 %5, 0
  %7 = select i1 %4, i1 %6, i1 false
  br i1 %7, label %8, label %11

8:
  %9 = getelementptr inbounds i8, ptr %0, i64 104
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
  %8 = getelementptr inbounds i8, ptr %0, i64 120
  %9 = load ptr, ptr %8, align 8
  %10 = tail call fastcc i64 @address(ptr %9) #17
  store i64 %10, ptr %7, align 8
  %11 = getelementptr inbounds i8, ptr %5, i64 24
  store i64 %2, ptr %11, align 8
  %12 = getelementptr inbounds i8, ptr %5, i64 32
  %13 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 272), align 8
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
  %22 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 224), align 8
  %23 = call fastcc ptr @reals(ptr %0, i64 %22) #17
  store double %21, ptr %23, align 8
  %24 = getelementptr inbounds i8, ptr %0, i64 56
  %25 = load double, ptr %24, align 8
  %26 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 232), align 8
  %27 = call fastcc ptr @reals(ptr %0, i64 %26) #17
  store double %25, ptr %27, align 8
  %28 = getelementptr inbounds i8, ptr %0, i64 64
  %29 = load i64, ptr %28, align 8
  %30 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 240), align 8
  %31 = call fastcc ptr @integers(ptr %0, i64 %30) #17
  store i64 %29, ptr %31, align 8
  %32 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 248), align 8
  %33 = call fastcc ptr @integers(ptr %0, i64 %32) #17
  store i64 %1, ptr %33, align 8
  %34 = load ptr, ptr @pp_entries, align 8
  %35 = getelementptr inbounds i8, ptr %0, i64 128
  %36 = load ptr, ptr %35, align 8
  %37 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 96), align 8
  %38 = getelementptr inbounds i8, ptr %36, i64 %37
  %39 = call fastcc i64 @address(ptr %38) #17
  %40 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 216), align 8
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
  %54 = getelementptr inbounds i8, ptr %0, i64 112
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
  %76 = getelementptr inbounds i8, ptr %0, i64 112
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

declare void @llvm.memset.p0.i64(ptr, i8, i64, i1 immarg) #14

define internal fastcc i32 @fits(ptr %0, i64 %1, i64 %2) unnamed_addr #1 {
  %4 = icmp eq i64 %1, %2
  br i1 %4, label %6, label %5

5:
  tail call fastcc void @fail(ptr %0, ptr @.str.71) #17
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
  %9 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 120), align 8
  %10 = tail call fastcc ptr @reals(ptr %0, i64 %9) #17
  %11 = load i64, ptr getelementptr inbounds (i8, ptr @pp_numbers, i64 256), align 8
  %12 = tail call fastcc i32 @all_finite(ptr %10, i64 %11) #17
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %16

14:
  %15 = phi i64 [ %6, %5 ], [ 4, %8 ]
  tail call fastcc void @stop(ptr %0, ptr @.str.72, i64 %15, ptr @.str.73) #17
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


