package org.urbi.kernel.node;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Values;

/**
 * What hot code is compiled to, and what such code calls. A value of it is a pair: a double, and an
 * object or null. Null stands for a plain number of which there is no object yet.
 */
public abstract class CompiledCode extends OwnCallAccess {
  /** What a loop does next. */
  private static final int RETURN = 0;

  private static final int BREAK = 1;
  private static final int CONTINUE = 2;

  /** How often it meets what it has not expected. */
  private final Misses misses;

  protected CompiledCode(Misses misses) {
    this.misses = misses;
  }

  /**
   * Runs it.
   *
   * @param from the number of the next turn, of a loop over numbers or elements
   * @param to before which number that loop ends
   * @param elements the elements of such a loop, or null
   */
  public abstract UrbiObject run(
      Frame frame, double from, double to, UrbiObject @Nullable [] elements);

  final UrbiObject run(Frame frame, double from, double to) {
    return run(frame, from, to, null);
  }

  /** Runs a loop over these elements, from that one on. */
  final UrbiObject over(Frame frame, int from, List<UrbiObject> elements) {
    return run(frame, from, elements.size(), elements.toArray(Frame.NO_ARGUMENTS));
  }

  @Override
  public final UrbiObject execute(Frame frame) {
    return run(frame, 0, 0, null);
  }

  /** Whether it has met so much that other code would be faster. */
  public final boolean isOutdated() {
    return misses.isOver();
  }

  public final Misses misses() {
    return misses;
  }

  // ------------------------------------------------------------------ calls

  /**
   * Calls a function without parameters whose code this is; code of others does not know how. The
   * answer is null for a number, which is then in the frame of the caller.
   */
  public @Nullable UrbiObject call(Function called, Frame caller, CallSite at, UrbiObject self) {
    throw new UnsupportedOperationException();
  }

  /** Calls the function with one argument. */
  public @Nullable UrbiObject call(
      Function called,
      Frame caller,
      CallSite at,
      UrbiObject self,
      double a,
      @Nullable UrbiObject first) {
    throw new UnsupportedOperationException();
  }

  /** Calls the function with two arguments. */
  public @Nullable UrbiObject call(
      Function called,
      Frame caller,
      CallSite at,
      UrbiObject self,
      double a,
      @Nullable UrbiObject first,
      double b,
      @Nullable UrbiObject second) {
    throw new UnsupportedOperationException();
  }

  /** Calls the function with three arguments. */
  public @Nullable UrbiObject call(
      Function called,
      Frame caller,
      CallSite at,
      UrbiObject self,
      double a,
      @Nullable UrbiObject first,
      double b,
      @Nullable UrbiObject second,
      double c,
      @Nullable UrbiObject third) {
    throw new UnsupportedOperationException();
  }

  // ------------------------------------------------------------------ values

  protected static boolean isNumber(UrbiObject value, Shape shape) {
    return value instanceof UrbiFloat && value.shape() == shape;
  }

  /** The value of an object that is a number. */
  protected static double number(UrbiObject value) {
    return ((UrbiFloat) value).value();
  }

  protected static boolean truth(UrbiObject value, Frame frame, @Nullable Node at) {
    try {
      return Truth.of(frame, value);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  /** Whether the value of what is not compiled is true. */
  protected static boolean holds(Node code, Frame frame, @Nullable Node at) {
    return truth(execute(code, frame, at), frame, at);
  }

  // ------------------------------------------------------------------ cases

  protected static boolean matches(
      UrbiObject value, Frame frame, Pattern pattern, @Nullable Node at) {
    try {
      return pattern.matches(frame, value);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  // ------------------------------------------------------------------ exceptions

  /** What the clauses of a {@code try} get to see. */
  protected static UrbiException caught(Throwable thrown, Frame frame, Try node) throws Throwable {
    return node.caught(frame, thrown);
  }

  protected static boolean catches(UrbiException exception, Frame frame, Try.Clause clause) {
    return clause.matches(frame, exception);
  }

  /** What {@code throw} throws. */
  protected static UrbiException thrown(UrbiObject value, Frame frame, Jumps.Throw node) {
    return node.thrown(frame, value);
  }

  /** What {@code throw} without a value throws. */
  protected static UrbiException thrownAgain(Frame frame, Jumps.Throw node) {
    return node.caught(frame);
  }

  /** From now on that exception is being handled; returns the one that was. */
  protected static @Nullable UrbiException handling(
      @Nullable UrbiException exception, Frame frame) {
    UrbiException outer = frame.caught;
    frame.caught = exception;
    return outer;
  }

  // ------------------------------------------------------------------ jumps

  /** How the statement that has set the completion of the frame leaves a loop around it. */
  protected static int leaving(Frame frame) {
    Frame.Completion completion = frame.completion;
    if (completion == Frame.Completion.RETURN) {
      return RETURN;
    }
    frame.completion = null;
    return completion == Frame.Completion.BREAK ? BREAK : CONTINUE;
  }

  /** The loop that is running, as a unit, is left by {@code return}. */
  protected static void returns(Frame frame) {
    frame.completion = Frame.Completion.RETURN;
  }

  /** The loop that is running, as a unit, is left by {@code break}. */
  protected static void breaks(Frame frame) {
    frame.completion = Frame.Completion.BREAK;
  }

  protected static boolean isBreak(Throwable leaving) {
    return leaving instanceof NonLocalExit.Break;
  }

  /** Whether that is {@code break} or {@code continue}. */
  protected static boolean isOfLoop(Throwable leaving) {
    return leaving instanceof NonLocalExit.Break || leaving instanceof NonLocalExit.Continue;
  }

  protected static LoopJobs beginLoop(Frame frame) {
    return LoopJobs.begin(frame);
  }

  protected static void endLoop(Frame frame, LoopJobs jobs, boolean broken) {
    jobs.end(frame, broken);
  }

  // ------------------------------------------------------------------ operators

  /** An operator whose left operand is no plain number, or which somebody has redefined. */
  protected static UrbiObject operate(UrbiObject left, Frame frame, NumericOperator operator) {
    return operator.message().sendTo(frame, left);
  }

  /** An operator whose right operand is no plain number. */
  protected static UrbiObject operate(
      UrbiObject left, UrbiObject right, Frame frame, NumericOperator operator) {
    return operator.message().sendTo(frame, left, right);
  }

  /** Whether an equality compares the objects, or strings, themselves. */
  protected static boolean equates(
      UrbiObject left, Frame frame, NumericOperator operator, @Nullable Node at) {
    try {
      return operator.equates(frame, left);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  /** Whether it is known to do so. */
  protected static boolean equatesAsBefore(UrbiObject left, NumericOperator operator) {
    return operator.equatesAsBefore(left);
  }

  /** The answer of such an equality; the right operand is not void. */
  protected static UrbiObject isSame(
      UrbiObject left, UrbiObject right, NumericOperator operator, Values values) {
    return values.bool(operator.isSame(left, right));
  }

  protected static UrbiObject successor(
      UrbiObject before, Frame frame, CompoundAssignment assignment) {
    try {
      return assignment.successor(frame, before);
    } catch (UrbiException e) {
      throw frame.located(e, assignment.span());
    }
  }

  protected static UrbiObject combined(
      UrbiObject before, UrbiObject by, Frame frame, CompoundAssignment assignment) {
    try {
      return assignment.combined(frame, before, by);
    } catch (UrbiException e) {
      throw frame.located(e, assignment.span());
    }
  }

  // ------------------------------------------------------------------ messages and slots

  /** Sends a message to a target that has been evaluated; the arguments are evaluated here. */
  protected static UrbiObject send(UrbiObject target, Frame frame, MessageSend message) {
    return message.sendTo(frame, target);
  }

  protected static @Nullable UrbiObject find(UrbiObject target, Frame frame, MessageSend message) {
    try {
      return message.find(frame, target);
    } catch (UrbiException e) {
      throw frame.located(e, message.span());
    }
  }

  /** Whether what was found takes that many evaluated arguments, and never sees their code. */
  public static boolean takes(@Nullable UrbiObject found, int arguments) {
    if (found instanceof Function function) {
      Formals formals = function.formals();
      return formals != null
          && !function.usesCall()
          && arguments >= formals.min()
          && arguments <= formals.max();
    }
    return found instanceof Code code && !code.isLazy();
  }

  /** Where to put the evaluated arguments. */
  protected static UrbiObject[] room(UrbiObject found, int arguments) {
    return new UrbiObject
        [found instanceof Function function && isSimple(function, arguments)
            ? function.layout().locals()
            : arguments];
  }

  /** Calls what was found, and {@linkplain #takes takes} the arguments. */
  protected static UrbiObject call(
      UrbiObject found,
      UrbiObject target,
      UrbiObject[] room,
      int arguments,
      Frame frame,
      CallSite message) {
    try {
      return found instanceof Function function && isSimple(function, arguments)
          ? function.run(frame, message, target, room)
          : ((Code) found).call(frame, message, target, room);
    } catch (UrbiException e) {
      throw located(e, frame, message.calledSpan());
    }
  }

  private static boolean isSimple(Function function, int arguments) {
    Formals formals = function.formals();
    return formals != null && formals.isSimple(arguments);
  }

  /** What was found answers; it evaluates the arguments. */
  protected static UrbiObject answer(
      @Nullable UrbiObject found, UrbiObject target, Frame frame, MessageSend message) {
    try {
      return message.answer(frame, found, target);
    } catch (UrbiException e) {
      throw frame.located(e, message.span());
    }
  }

  /** The value of a variable answers, called as a function; it evaluates the arguments. */
  protected static UrbiObject answer(UrbiObject value, Frame frame, MessageSend.OfLocal call) {
    try {
      return call.answer(frame, value);
    } catch (UrbiException e) {
      throw frame.located(e, call.span());
    }
  }

  protected static void declare(Frame frame, UrbiObject value, Variables.Place place) {
    place.declare(frame, value);
  }

  protected static void assign(
      Frame frame, UrbiObject value, Variables.Place place, @Nullable Node at) {
    try {
      place.assign(frame, value);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  protected static void declare(
      UrbiObject target, UrbiObject value, Frame frame, Slots.Declare declaration) {
    declaration.create(frame, target, value);
  }

  /** The value of a slot that is going to be modified. */
  protected static UrbiObject before(
      UrbiObject target, Frame frame, CompoundAssignment assignment) {
    try {
      return assignment.access().read(frame, new UrbiObject[] {target});
    } catch (UrbiException e) {
      throw frame.located(e, assignment.span());
    }
  }

  protected static UrbiObject assign(
      UrbiObject target,
      UrbiObject value,
      Frame frame,
      Slots.Assign assignment,
      @Nullable Node at) {
    try {
      return assignment.assign(frame, target, value);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  // ------------------------------------------------------------------ lists

  protected static Elements newElements(int room) {
    return new Elements(room);
  }

  protected static void add(Elements elements, UrbiObject element) {
    elements.add(element);
  }

  /** The value of a literal whose elements have been evaluated. */
  protected static UrbiObject sequence(Elements elements, Frame frame, Literals.Sequence literal) {
    return literal.of(frame, elements);
  }

  /** The element at an index; null if the list, or the index, is another than is expected. */
  protected static @Nullable UrbiObject element(UrbiObject target, double index) {
    if (target instanceof UrbiList list) {
      List<UrbiObject> elements = list.elements();
      int place = place(index, elements.size());
      if (place >= 0) {
        return elements.get(place);
      }
    }
    return null;
  }

  /**
   * The value of a key; null if there is none, or the dictionary or key is another than expected.
   */
  protected static @Nullable UrbiObject entry(UrbiObject target, UrbiObject key, Frame frame) {
    return target instanceof UrbiDictionary dictionary && DictionaryKey.isPlain(key)
        ? dictionary.getPlain(key)
        : null;
  }

  /** Whether there is a key; null if the dictionary or key is another than expected. */
  protected static @Nullable UrbiObject hasEntry(UrbiObject target, UrbiObject key, Frame frame) {
    return target instanceof UrbiDictionary dictionary && DictionaryKey.isPlain(key)
        ? frame.interpreter.values().bool(dictionary.getPlain(key) != null)
        : null;
  }

  /**
   * Sets the value of a key; false if the key or dictionary is another than expected, such as one
   * with slots of its own, which may be events that tell of it.
   */
  protected static boolean setEntry(
      UrbiObject target, UrbiObject key, UrbiObject value, Frame frame) {
    return target instanceof UrbiDictionary dictionary
        && dictionary.shape() == frame.interpreter.values().dictionaryProto.cloneShape()
        && frame.job.isOwner()
        && dictionary.putPlain(key, value);
  }

  private static int place(double index, int size) {
    int place = (int) index;
    if (place != index || place >= size) {
      return -1;
    }
    return place < 0 ? place + size : place;
  }

  /**
   * Replaces the element at an index; false if something is not as expected, as where somebody may
   * have to be told.
   */
  protected static boolean setElement(UrbiObject target, double index, UrbiObject value, Job job) {
    if (target instanceof UrbiList list && job.isOwner() && !list.isContentWatched()) {
      Elements elements = list.modify();
      int place = place(index, elements.size());
      if (place >= 0) {
        elements.set(place, value);
        return true;
      }
    }
    return false;
  }

  /** Adds an element at the end; false if something is not as expected, as in the one above. */
  protected static boolean append(UrbiObject target, UrbiObject value, Job job) {
    if (target instanceof UrbiList list && job.isOwner() && !list.isContentWatched()) {
      list.modify().add(value);
      return true;
    }
    return false;
  }

  /** The other truth value; null if the target is something else. */
  protected static @Nullable UrbiObject not(UrbiObject target, Frame frame) {
    Values values = frame.interpreter.values();
    if (target == values.trueObject) {
      return values.falseObject;
    }
    return target == values.falseObject ? values.trueObject : null;
  }

  /** The number of elements; -1 if the target is no list. */
  protected static double sizeOfList(UrbiObject target) {
    return target instanceof UrbiList list ? list.elements().size() : -1;
  }

  /** The number of characters; -1 if the target is no string. */
  protected static double sizeOfText(UrbiObject target) {
    return target instanceof UrbiString text ? text.value().length() : -1;
  }

  /** The number of entries; -1 if the target is no dictionary. */
  protected static double sizeOfDictionary(UrbiObject target) {
    return target instanceof UrbiDictionary dictionary ? dictionary.entries().size() : -1;
  }

  /** The element that is going to be modified. */
  protected static UrbiObject before(
      UrbiObject target, UrbiObject index, Frame frame, CompoundAssignment assignment) {
    try {
      return assignment.access().read(frame, new UrbiObject[] {target, index});
    } catch (UrbiException e) {
      throw frame.located(e, assignment.span());
    }
  }

  /** Writes it. */
  protected static void write(
      UrbiObject target,
      UrbiObject index,
      UrbiObject value,
      Frame frame,
      CompoundAssignment assignment) {
    try {
      assignment.access().write(frame, new UrbiObject[] {target, index}, value);
    } catch (UrbiException e) {
      throw frame.located(e, assignment.span());
    }
  }

  // ------------------------------------------------------------------ loops

  /** The elements over which a loop goes; null if the range is no plain list. */
  protected static UrbiObject @Nullable [] elements(UrbiObject range, ForEach loop) {
    return range instanceof UrbiList list && loop.isOfLibrary(range)
        ? list.elements().toArray(Frame.NO_ARGUMENTS)
        : null;
  }

  /** Whether a loop counts up to that value. */
  protected static boolean isCount(UrbiObject range, ForEach loop) {
    return range instanceof UrbiFloat && loop.isOfLibrary(range);
  }

  /** A loop over anything but a number. */
  protected static UrbiObject iterate(
      UrbiObject range, Frame frame, ForEach loop, @Nullable Node at) {
    try {
      return loop.iterate(frame, range);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }
}
