package org.urbi.kernel.tier;

import java.lang.constant.ClassDesc;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.job.YieldCount;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.CompiledCode;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.KnownSlot;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.LoopJobs;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Misses;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.OwnCalls;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.Try;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Dependencies;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiCode;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.object.World;

/** The types that emitted code uses. */
final class Names {
  static final ClassDesc COMPILED_CODE = of(CompiledCode.class);
  static final ClassDesc CONTROL_FLOW = of(ControlFlowException.class);
  static final ClassDesc COUNTING = of(CompoundAssignment.class);
  static final ClassDesc DOUBT = of(Doubt.class);
  static final ClassDesc ELEMENTS = of(Elements.class);
  static final ClassDesc OWN_CALLS = of(OwnCalls.class);
  static final ClassDesc PATTERN = of(Pattern.class);
  static final ClassDesc SEQUENCE = of(Literals.Sequence.class);
  static final ClassDesc FOR_EACH = of(ForEach.class);
  static final ClassDesc FRAME = of(Frame.class);
  static final ClassDesc FUNCTION = of(Function.class);
  static final ClassDesc INTERPRETER = of(Interpreter.class);
  static final ClassDesc JOB = of(Job.class);
  static final ClassDesc KNOWN_SLOT = of(KnownSlot.class);
  static final ClassDesc LOOP_JOBS = of(LoopJobs.class);
  static final ClassDesc MESSAGE = of(MessageSend.class);
  static final ClassDesc MISSES = of(Misses.class);
  static final ClassDesc NODE = of(Node.class);
  static final ClassDesc OBJECT = of(UrbiObject.class);
  static final ClassDesc OBJECTS = of(UrbiObject[].class);
  static final ClassDesc OPERATOR = of(NumericOperator.class);
  static final ClassDesc PLACE = of(Variables.Place.class);
  static final ClassDesc SLOT_DECLARATION = of(Slots.Declare.class);
  static final ClassDesc LOCAL_CALL = of(MessageSend.OfLocal.class);
  static final ClassDesc SCOPE_END = of(ScopeEnd.class);
  static final ClassDesc SITE = of(CallSite.class);
  static final ClassDesc SHAPE = of(Shape.class);
  static final ClassDesc SLOT_ASSIGNMENT = of(Slots.Assign.class);
  static final ClassDesc SYMBOL = of(Symbol.class);
  static final ClassDesc BODY = of(Function.Body.class);
  static final ClassDesc CLAUSE = of(Try.Clause.class);
  static final ClassDesc EXCEPTION = of(UrbiException.class);
  static final ClassDesc TRY = of(Try.class);
  static final ClassDesc THROW = of(Jumps.Throw.class);
  static final ClassDesc THROWABLE = of(Throwable.class);
  static final ClassDesc TRACKER = of(Dependencies.Tracker.class);
  static final ClassDesc CODE = of(UrbiCode.class);
  static final ClassDesc WORLD = of(World.class);
  static final ClassDesc VALUES = of(Values.class);
  static final ClassDesc YIELDS = of(YieldCount.class);

  private Names() {}

  private static ClassDesc of(Class<?> type) {
    return type.describeConstable().orElseThrow();
  }
}
