package org.urbi.kernel.tier;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CompoundAssignment;
import org.urbi.kernel.node.Conditionals;
import org.urbi.kernel.node.ForEach;
import org.urbi.kernel.node.Function;
import org.urbi.kernel.node.Jumps;
import org.urbi.kernel.node.Literals;
import org.urbi.kernel.node.Loops;
import org.urbi.kernel.node.Matching;
import org.urbi.kernel.node.MessageSend;
import org.urbi.kernel.node.Node;
import org.urbi.kernel.node.NumericOperator;
import org.urbi.kernel.node.Pattern;
import org.urbi.kernel.node.ScopeEnd;
import org.urbi.kernel.node.Sequences;
import org.urbi.kernel.node.Slots;
import org.urbi.kernel.node.Try;
import org.urbi.kernel.node.Variables;
import org.urbi.kernel.object.Symbol;

/** What a piece of code does to the variables of its frame. */
final class Survey {
  private final BitSet assigned = new BitSet();
  private final BitSet inArguments = new BitSet();
  private final BitSet mentioned = new BitSet();
  private boolean hides;
  private boolean jumps;
  private boolean closures;
  private boolean passes;
  private boolean handsOutCode;
  private boolean handsOutJobs;
  private boolean pauses;
  private boolean callsLocal;
  private int loops;
  private final List<MessageSend> messages = new ArrayList<>();
  private final BitSet assignedInArguments = new BitSet();
  private int operations;
  private int depth;

  static Survey of(@Nullable Node node) {
    Survey survey = new Survey();
    survey.visit(node);
    return survey;
  }

  /** What the turns of a loop do. */
  static Survey ofTurns(Node node) {
    Survey survey = new Survey();
    if (node instanceof Loops.Sequential loop) {
      survey.pauses = loop.yields();
      survey.visit(loop.condition());
      survey.visit(loop.step());
      survey.visit(loop.body());
    } else if (node instanceof ForEach loop) {
      survey.pauses = loop.yields();
      survey.visit(loop.body());
    }
    return survey;
  }

  /** What a whole function does, with the defaults of its parameters. */
  static Survey of(Function.Body function) {
    Survey survey = of(function.text());
    function.defaults().forEach(survey::visit);
    return survey;
  }

  /**
   * Others may reach the variables by lazy arguments that are in the code around this, too.
   *
   * @param around null if nobody knows that code: they may reach all
   */
  void addAround(@Nullable Survey around) {
    inArguments.or(mentionedAmong(around == null || around.hides ? null : around.inArguments));
    assignedInArguments.or(
        mentionedAmong(around == null || around.hides ? null : around.assignedInArguments));
    handsOutCode |= around == null || around.handsOutCode();
    handsOutJobs |= around == null || around.handsOutJobs();
  }

  private BitSet mentionedAmong(@Nullable BitSet others) {
    var both = (BitSet) mentioned.clone();
    if (others != null) {
      both.and(others);
    }
    return both;
  }

  /** Whether compiled code assigns the variable. */
  boolean assigns(int variable) {
    return assigned.get(variable);
  }

  /** Whether it may read or assign the variable, itself or by code that is not compiled. */
  boolean mayMention(int variable) {
    return hides || mentioned.get(variable);
  }

  /** Whether it may assign the variable, itself or by code that is not compiled. */
  boolean mayAssign(int variable) {
    return hides || assigned.get(variable);
  }

  /** Whether code that is not compiled, or a lazy argument, may assign the variable. */
  boolean isAssignedElsewhere(int variable) {
    return hides || assignedInArguments.get(variable);
  }

  /** Whether a lazy argument may read or assign the variable. */
  boolean mayExpose(int variable) {
    return hides || inArguments.get(variable);
  }

  /**
   * Whether its own code may detach jobs: code that is not compiled, or a function that does so
   * with its argument. Operators and what others evaluate are left to {@link EmitLoops}, which
   * knows what has been called.
   */
  boolean mayDetach() {
    return hides || passes;
  }

  /** Whether it hands out code that may ask for the scope around it, now or later. */
  boolean handsOutCode() {
    return hides || handsOutCode;
  }

  /** Whether it hands out code that may detach jobs, now or later. */
  boolean handsOutJobs() {
    return hides || handsOutJobs;
  }

  /** Whether there is a {@code ;} in it, and no loop or other code that may take long. */
  boolean pausesOften() {
    return pauses && loops == 0 && !hides && !passes && !callsLocal;
  }

  /** Whether there is a {@code ;} in it, and otherwise only what takes no longer than that. */
  boolean isMostlyPauses() {
    return pausesOften() && messages.isEmpty();
  }

  /** Whether it may call somebody in other ways than by a message that is known. */
  boolean mayCallUnseen() {
    return hides || callsLocal;
  }

  /** The messages that are sent in it. */
  List<MessageSend> messages() {
    return messages;
  }

  /** Whether {@code break} and {@code continue} may come out of it as exceptions. */
  boolean mayJump() {
    return hides || closures;
  }

  /**
   * Whether that can be compiled: not if {@code finally} would have to be executed on the way of a
   * jump.
   */
  static boolean canEmit(Try node) {
    if (node.finallyClause() == null) {
      return true;
    }
    Survey inside = new Survey();
    inside.visitParts(node);
    return !(inside.hides || inside.jumps);
  }

  private void visitParts(Try node) {
    visit(node.body());
    for (Try.Clause clause : node.clauses()) {
      if (clause.pattern() != null) {
        visit(clause.pattern());
      }
      visit(clause.guard());
      visit(clause.body());
    }
    visit(node.elseClause());
    visit(node.finallyClause());
  }

  /** Whether more is gained than an execution of the node takes; a call of it, at least. */
  boolean isWorthwhile() {
    return operations > 0 || !hides;
  }

  /** Whether the code only reads variables and constants. */
  static boolean isSimple(Node node) {
    return node instanceof Literals.Number || node instanceof Variables.Local || isLeaf(node);
  }

  /** Whether the code does not touch the plain variables of the frame, and may be just called. */
  static boolean isLeaf(Node node) {
    return node instanceof Literals.Text
        || node instanceof Literals.This
        || node instanceof Literals.Closure
        || node instanceof Variables.Shared
        || node instanceof Sequences.Noop;
  }

  private void assign(int variable) {
    mentioned.set(variable);
    assigned.set(variable);
    if (depth > 0) {
      assignedInArguments.set(variable);
      inArguments.set(variable);
    }
  }

  /**
   * Something is called.
   *
   * @param detaches whether it is a function that may detach its argument
   */
  private void calls(boolean detaches) {
    passes |= detaches;
    handsOutCode |= depth > 0;
    handsOutJobs |= detaches && depth > 0;
  }

  private void visitAll(Node... nodes) {
    for (Node node : nodes) {
      visit(node);
    }
  }

  private void visit(@Nullable Node node) {
    if (node == null || isLeaf(node) || node instanceof Literals.Number) {
      closures |= node instanceof Literals.Closure;
      return;
    }
    if (node instanceof Variables.Local read) {
      mentioned.set(read.index());
      if (depth > 0) {
        inArguments.set(read.index());
      }
    } else if (visitStatement(node) || visitExpression(node)) {
      operations++;
    } else {
      hides = true;
    }
  }

  /** What a pattern reads and assigns. */
  static Survey of(Pattern pattern) {
    Survey survey = new Survey();
    survey.visit(pattern);
    return survey;
  }

  private void visit(Pattern pattern) {
    pattern.tell(
        new Pattern.Parts() {
          @Override
          public void variable(Variables.Place place) {
            if (place.declaredLocal() >= 0) {
              assign(place.declaredLocal());
            }
          }

          @Override
          public void code(Node node) {
            visit(node);
          }
        });
  }

  private boolean visitStatement(Node node) {
    if (node instanceof Sequences.Chain chain) {
      for (int i = 0; i < chain.statements().length; i++) {
        pauses |= i < chain.statements().length - 1 && chain.yieldsAfter(i);
        visit(chain.statements()[i]);
      }
    } else if (node instanceof Sequences.Located located) {
      visit(located.code());
    } else if (node instanceof ScopeEnd.Scope scope) {
      visit(scope.body());
    } else if (node instanceof Conditionals.If choice) {
      visit(choice.condition());
      visit(choice.thenClause());
      visit(choice.elseClause());
    } else if (node instanceof Loops.Sequential loop) {
      loops++;
      visit(loop.init());
      visit(loop.condition());
      visit(loop.step());
      visit(loop.body());
    } else if (node instanceof ForEach loop && EmitLoops.canCount(loop)) {
      loops++;
      assign(loop.variable().declaredLocal());
      visit(loop.range());
      visit(loop.body());
    } else if (node instanceof Matching.Switch choice) {
      visit(choice.value());
      for (Matching.Case each : choice.cases()) {
        visit(each.pattern());
        visit(each.guard());
        visit(each.body());
      }
      visit(choice.defaultCase());
    } else if (node instanceof Try attempt && canEmit(attempt)) {
      visitParts(attempt);
    } else if (node instanceof Jumps.Return jump && jump.isPlain()) {
      jumps = true;
      visit(jump.value());
    } else if (node instanceof Jumps.OfLoop jump && jump.isPlain()) {
      jumps = true;
    } else if (node instanceof Jumps.Throw jump) {
      visit(jump.value());
    } else {
      return false;
    }
    return true;
  }

  private boolean visitExpression(Node node) {
    if (node instanceof NumericOperator operator) {
      visit(operator.left());
      depth++;
      visit(operator.right());
      depth--;
    } else if (node instanceof Conditionals.Logical logical) {
      visit(logical.left());
      visit(logical.right());
    } else if (node instanceof Variables.Declare declaration
        && EmitVariables.isPlain(declaration)) {
      assign(declaration.place().declaredLocal());
      visit(declaration.value());
    } else if (node instanceof Variables.Declare declaration
        && EmitVariables.isPlainlyShared(declaration)) {
      visit(declaration.value());
    } else if (node instanceof Variables.Assign assignment) {
      if (assignment.place().local() >= 0) {
        assign(assignment.place().local());
      }
      visit(assignment.value());
    } else if (node instanceof CompoundAssignment assignment
        && assignment.access() instanceof CompoundAssignment.OfVariable access) {
      visit(access.variable());
      if (assignment.local() >= 0) {
        assign(assignment.local());
      }
      visit(assignment.operand());
    } else if (node instanceof CompoundAssignment assignment
        && assignment.access() instanceof CompoundAssignment.Element element
        && element.indices().length == 1) {
      visit(element.target());
      visitAll(element.indices());
      visit(assignment.operand());
    } else if (node instanceof Literals.Sequence literal) {
      visitAll(literal.elements());
    } else if (node instanceof MessageSend.OfLocal call) {
      calls(call.argumentNodes().length > 0);
      callsLocal = true;
      visit(call.variable());
      depth++;
      visitAll(call.argumentNodes());
      depth--;
    } else if (node instanceof Slots.Declare declaration && declaration.isPlain()) {
      visit(declaration.target());
      visit(declaration.value());
    } else if (node instanceof CompoundAssignment assignment
        && assignment.access() instanceof CompoundAssignment.Slot slot) {
      visit(slot.target());
      visit(assignment.operand());
    } else if (node instanceof Slots.Assign assignment) {
      visit(assignment.target());
      visit(assignment.value());
    } else if (node instanceof MessageSend message) {
      messages.add(message);
      calls(message.argumentNodes().length > 0 && Symbol.isWord(message.calledName()));
      visit(message.target());
      depth++;
      visitAll(message.argumentNodes());
      depth--;
    } else {
      return false;
    }
    return true;
  }
}
