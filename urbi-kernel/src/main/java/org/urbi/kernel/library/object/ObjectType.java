package org.urbi.kernel.library.object;

import java.util.Arrays;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.Set;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.job.Steps;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.node.TakenCode;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.Ancestors;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** The functions of every object, except those about slots (manual, "Object"). */
@UrbiType(
    value = "Object",
    protos = {"Comparable", "Global"},
    doc = "What all objects inherit from.",
    needs = Permission.NOTHING)
public final class ObjectType {
  private ObjectType() {}

  @Builtin(
      value = {"acceptVoid", "unacceptVoid"},
      doc = "The target, which is not void.")
  static UrbiObject acceptVoid(UrbiObject self) {
    return self;
  }

  @Builtin(doc = "Puts a prototype in front of the others.", needs = Permission.CHANGE)
  static UrbiObject addProto(Frame frame, CallSite site, UrbiObject self, UrbiObject proto) {
    FinalizableType.check(frame, site.calledName(), self, proto);
    checkNumber(frame, site, self, proto);
    self.addProto(proto);
    return self;
  }

  @Builtin(doc = "The object, its prototypes, their prototypes and so on.")
  public static Collection<UrbiObject> allProtos(UrbiObject self) {
    return Ancestors.of(self);
  }

  @Builtin(doc = "The object itself, whatever the one argument in the list is.")
  static UrbiObject apply(Frame frame, UrbiObject self, UrbiList arguments) {
    int given = arguments.elements().size();
    if (given == 0) {
      throw frame.interpreter().errors().primitive("apply", Problem.WITHOUT_THIS);
    }
    if (given > 1) {
      throw frame.interpreter().errors().arity("apply", given - 1, 0, 0);
    }
    return self;
  }

  @Builtin(doc = "Converts to a type: calls the method asType of that type.")
  static UrbiObject as(Frame frame, UrbiObject self, UrbiObject type) {
    String name =
        frame.interpreter().asString(frame, frame.interpreter().send(frame, type, "type"));
    return frame.interpreter().send(frame, self, "as" + name);
  }

  @Builtin(doc = "Whether it counts as true.")
  static boolean asBool(Frame frame, UrbiObject self) {
    return Truth.of(self, frame.interpreter().values());
  }

  @Builtin(doc = "The object as the console shows it.")
  static UrbiObject asPrintable(Frame frame, UrbiObject self) {
    return frame.interpreter().send(frame, self, "asString");
  }

  @Builtin(doc = "The object as a string: its type, and its identifier unless it is a type.")
  public static String asString(Frame frame, UrbiObject self) {
    Symbol type = frame.interpreter().symbols().type;
    String name =
        frame.interpreter().asString(frame, frame.interpreter().send(frame, self, "type"));
    return self.localSlot(type) != null ? name : name + "_" + uid(self);
  }

  @Builtin(doc = "The object as the top level shows it.")
  static UrbiObject asToplevelPrintable(Frame frame, UrbiObject self) {
    return frame.interpreter().send(frame, self, "asPrintable");
  }

  @Builtin(doc = "A method without arguments turned into a function of its target.")
  static UrbiObject bounce(Frame frame, UrbiObject self, String name) {
    return TakenCode.by(frame, new BouncedCode(self.world(), name));
  }

  @Builtin(
      value = {"clone"},
      doc = "A fresh object whose only prototype is the target.")
  static UrbiObject cloneOf(Frame frame, UrbiObject self) {
    UrbiObject made = self.cloned();
    PermissionCheck.claimForObserver(frame, made);
    return made;
  }

  @Builtin(
      value = {"new"},
      doc = "A clone, initialized by its method init with these arguments.")
  static UrbiObject newOf(Frame frame, CallSite site, UrbiObject self, UrbiObject... arguments) {
    UrbiObject made = frame.interpreter().send(frame, self, "clone");
    PermissionCheck.claimForObserver(frame, made);
    frame.interpreter().send(frame, site, made, frame.interpreter().symbols().init, arguments);
    return made;
  }

  @Builtin(doc = "Initializes a fresh clone; does nothing.")
  static UrbiObject init(UrbiObject self) {
    return self;
  }

  @Builtin(doc = "Whether that object is this one or one of its ancestors.")
  static boolean isA(UrbiObject self, UrbiObject ancestor) {
    return self.isA(ancestor);
  }

  @Builtin(doc = "Whether it is nil.")
  static boolean isNil(UrbiObject self) {
    return self == self.world().values().nil;
  }

  @Builtin(
      doc =
          "Whether it is a prototype with a name: it has a slot type of its own, as classes have.")
  static boolean isProto(UrbiObject self) {
    return self.localSlot(self.world().symbol("type")) != null;
  }

  @Builtin(doc = "Whether it is void.")
  static boolean isVoid(UrbiObject self) {
    return false;
  }

  @Builtin(doc = "The list of the prototypes, first looked up first; it may be modified.")
  static UrbiObject protos(Frame frame, UrbiObject self) {
    UrbiList protos = self.world().values().list(Arrays.asList(self.protos()));
    if (PermissionCheck.allowsChange(frame, self)) {
      protos.watchContent(() -> self.setProtos(protos.elements().toArray(UrbiObject[]::new)));
    }
    return protos;
  }

  @Builtin(
      value = "protos",
      setter = true,
      doc = "Replaces the list of the prototypes.",
      needs = Permission.CHANGE)
  static void assignProtos(Frame frame, UrbiObject self, UrbiList protos) {
    replaceProtos(frame, "updateSlot", self, protos);
  }

  @Builtin(doc = "Takes a prototype away.", needs = Permission.CHANGE)
  static UrbiObject removeProto(UrbiObject self, UrbiObject proto) {
    self.removeProto(proto);
    return self;
  }

  @Builtin(doc = "Replaces the list of the prototypes.", needs = Permission.CHANGE)
  static void setProtos(Frame frame, CallSite site, UrbiObject self, UrbiList protos) {
    replaceProtos(frame, site.calledName(), self, protos);
  }

  private static void replaceProtos(Frame frame, String routine, UrbiObject self, UrbiList protos) {
    Set<UrbiObject> distinct = new LinkedHashSet<>();
    for (UrbiObject proto : protos.elements()) {
      frame.job().worked(Steps.OBJECT);
      FinalizableType.check(frame, routine, self, proto);
      distinct.add(proto);
    }
    self.setProtos(distinct.toArray(UrbiObject[]::new));
  }

  /** Refuses to make something a number by its prototypes: it would have no value. */
  private static void checkNumber(Frame frame, CallSite site, UrbiObject self, UrbiObject proto) {
    if (proto instanceof UrbiFloat && !(self instanceof UrbiFloat)) {
      throw frame.error(site, Problem.NOT_INHERITABLE_FLOAT);
    }
  }

  @Builtin(doc = "The identifier of the object, unique in this kernel.")
  public static String uid(UrbiObject self) {
    return "0x" + Long.toHexString(self.uid());
  }

  @Builtin(
      value = {"=="},
      doc = "Whether both are equal; unless redefined, whether they are the same object.")
  static boolean equal(UrbiObject self, UrbiObject other) {
    return self == other;
  }

  @Builtin(
      value = {"==="},
      doc = "Whether both are the same object.")
  static boolean same(UrbiObject self, UrbiObject other) {
    return self == other;
  }

  @Builtin(
      value = {"!=="},
      doc = "Whether both are not the same object.")
  static boolean notSame(UrbiObject self, UrbiObject other) {
    return self != other;
  }

  @Builtin(
      value = {"!"},
      doc = "Whether it counts as false.")
  static boolean not(Frame frame, UrbiObject self) {
    return !Truth.of(frame, self);
  }

  @Builtin(
      value = {"+="},
      doc = "The sum, by the method '+'.")
  static UrbiObject plusAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "+", other);
  }

  @Builtin(
      value = {"-="},
      doc = "The difference, by the method '-'.")
  static UrbiObject minusAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "-", other);
  }

  @Builtin(
      value = {"*="},
      doc = "The product, by the method '*'.")
  static UrbiObject timesAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "*", other);
  }

  @Builtin(
      value = {"/="},
      doc = "The quotient, by the method '/'.")
  static UrbiObject divideAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "/", other);
  }

  @Builtin(
      value = {"%="},
      doc = "The remainder, by the method '%'.")
  static UrbiObject moduloAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "%", other);
  }

  @Builtin(
      value = {"^="},
      doc = "The exclusive or, by the method '^'.")
  static UrbiObject xorAssign(Frame frame, UrbiObject self, UrbiObject other) {
    return frame.interpreter().send(frame, self, "^", other);
  }

  /** The values of the kernel to which an object belongs. */
  static Values values(UrbiObject object) {
    return object.world().values();
  }
}
