package org.urbi.tests;

import static com.tngtech.archunit.lang.SimpleConditionEvent.violated;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static java.util.Map.entry;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassModel;
import java.lang.classfile.CodeElement;
import java.lang.classfile.CodeModel;
import java.lang.classfile.Instruction;
import java.lang.classfile.Label;
import java.lang.classfile.MethodModel;
import java.lang.classfile.Opcode;
import java.lang.classfile.TypeKind;
import java.lang.classfile.instruction.ArrayStoreInstruction;
import java.lang.classfile.instruction.ExceptionCatch;
import java.lang.classfile.instruction.FieldInstruction;
import java.lang.classfile.instruction.InvokeDynamicInstruction;
import java.lang.classfile.instruction.InvokeInstruction;
import java.lang.classfile.instruction.LabelTarget;
import java.lang.classfile.instruction.LoadInstruction;
import java.lang.classfile.instruction.LocalVariable;
import java.lang.classfile.instruction.ReturnInstruction;
import java.lang.classfile.instruction.StoreInstruction;
import java.lang.classfile.instruction.ThrowInstruction;
import java.lang.classfile.instruction.TypeCheckInstruction;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * No bug of ours ends in silence: what catches everything there is throws it again, or hands it on,
 * with its stack, to a log or to whoever waits. A text made of it is not enough.
 */
final class CatchLaw {
  private CatchLaw() {}

  /** To catch one of these is to catch what nobody has thought of. */
  private static final Set<String> WIDE =
      Set.of(
          "java/lang/Throwable",
          "java/lang/Exception",
          "java/lang/RuntimeException",
          "java/lang/Error");

  /** The types by which it is handed on. */
  private static final Set<String> TAKING =
      Set.of(
          "Ljava/lang/Throwable;",
          "Ljava/lang/Exception;",
          "Ljava/lang/RuntimeException;",
          "Ljava/lang/Error;",
          "Ljava/lang/Object;");

  /** Methods that only make a text of it. */
  private static final Set<String> TEXTS =
      Set.of(
          "java/lang/String.valueOf",
          "java/util/Objects.toString",
          "java/lang/StringBuilder.append",
          "java/io/PrintStream.println",
          "urbi/spi/Failure.text",
          "urbi/thread/InternalFailure.text",
          "org/urbi/ros/graph/Failures.text",
          "org/urbi/kernel/log/FailureLog.text");

  private static final String LOG_ITSELF = "the log fails: that is told on the error stream";
  private static final String CLOSED_JAVA = "Java is not opened that far: jobs are other threads";
  private static final String NO_MEMORY =
      "memory is exhausted, and this is what makes room; it counts its attempts, and gives up";

  /** Methods, as class and name, that may forget what they have caught, and why. */
  private static final Map<String, String> EXCUSED =
      Map.ofEntries(
          entry("org.urbi.kernel.log.FailureLog.write", LOG_ITSELF),
          entry("urbi.thread.InternalFailure.log", LOG_ITSELF),
          entry("org.urbi.kernel.log.WatchFailure.met", "it is logged the next time"),
          entry("org.urbi.kernel.job.KernelThreadPin.find", CLOSED_JAVA),
          entry("org.urbi.kernel.job.TickLoopThread.findBuilder", CLOSED_JAVA),
          entry("org.urbi.kernel.job.TickLoopThread.findOthers", CLOSED_JAVA),
          entry("org.urbi.kernel.memory.MemoryRescue.rescue", NO_MEMORY),
          entry("org.urbi.kernel.memory.MemoryRescue.attemptAgain", NO_MEMORY),
          entry("org.urbi.kernel.memory.MemoryRescue.giveUp", NO_MEMORY),
          entry(
              "org.urbi.kernel.embed.ListenerQueue.tell",
              "a handler of the program; the failure that it was told is logged already"),
          entry(
              "org.urbi.kernel.embed.UrbiValue.toString",
              "it never throws; the kernel has logged what is a bug of its own"),
          entry(
              "org.urbi.kernel.outside.ProcessTree.begunBy",
              "the machine has no descriptor left, and this is how Java tells it"),
          entry(
              "org.urbi.server.console.ErrorOutput.write",
              "the error stream itself, where the log is written"));

  @ArchTest
  static final ArchRule whateverIsCaughtIsHandedOn =
      classes()
          .should(
              new ArchCondition<JavaClass>("hand on whatever they catch") {
                private final Set<String> used = new TreeSet<>();
                private JavaClass last;

                @Override
                public void check(JavaClass type, ConditionEvents events) {
                  last = type;
                  for (String method : silentIn(classFile(type))) {
                    if (EXCUSED.containsKey(method)) {
                      used.add(method);
                    } else {
                      events.add(violated(type, method + " forgets what it catches"));
                    }
                  }
                }

                @Override
                public void finish(ConditionEvents events) {
                  EXCUSED.keySet().stream()
                      .filter(method -> !used.contains(method))
                      .forEach(method -> events.add(violated(last, method + " needs no excuse")));
                }
              });

  /** The compiled class. */
  static ClassModel classFile(JavaClass type) {
    try (InputStream in = type.getSource().orElseThrow().getUri().toURL().openStream()) {
      return ClassFile.of().parse(in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The methods of a class that catch whatever there is, and forget it. */
  static Set<String> silentIn(ClassModel type) {
    String owner = type.thisClass().asInternalName().replace('/', '.');
    Set<String> silent = new TreeSet<>();
    for (MethodModel method : type.methods()) {
      method
          .code()
          .filter(CatchLaw::isSilent)
          .ifPresent(code -> silent.add(owner + "." + nameInSource(method)));
    }
    return silent;
  }

  /** Of a lambda the method that it is written in. */
  private static String nameInSource(MethodModel method) {
    String name = method.methodName().stringValue();
    return name.startsWith("lambda$") ? name.split("\\$")[1] : name;
  }

  private static boolean isSilent(CodeModel code) {
    List<CodeElement> elements = code.elementList();
    return code.exceptionHandlers().stream()
        .filter(CatchLaw::isWide)
        .map(ExceptionCatch::handler)
        .distinct()
        .anyMatch(handler -> !isHandedOn(elements, handler));
  }

  private static boolean isWide(ExceptionCatch caught) {
    return caught.catchType().filter(type -> WIDE.contains(type.asInternalName())).isPresent();
  }

  private static boolean isHandedOn(List<CodeElement> code, Label handler) {
    int begin = nextInstruction(code, place(code, handler));
    if (!(code.get(begin) instanceof StoreInstruction caught)) {
      return false;
    }
    int end = endOfVariable(code, begin, caught.slot());
    for (int i = begin + 1; i < end; i++) {
      if (code.get(i) instanceof LoadInstruction load
          && load.typeKind() == TypeKind.REFERENCE
          && load.slot() == caught.slot()
          && isTaken(code, i)) {
        return true;
      }
    }
    return false;
  }

  private static int place(List<CodeElement> code, Label label) {
    int at = 0;
    while (!(code.get(at) instanceof LabelTarget target && target.label().equals(label))) {
      at++;
    }
    return at;
  }

  private static int nextInstruction(List<CodeElement> code, int from) {
    int at = from;
    while (!(code.get(at) instanceof Instruction)) {
      at++;
    }
    return at;
  }

  /**
   * Where the variable ends that has just got its value; the end of the code if the compiler has
   * made it, as it does for resources that are closed.
   */
  private static int endOfVariable(List<CodeElement> code, int stored, int slot) {
    int next = nextInstruction(code, stored + 1);
    for (CodeElement element : code) {
      if (element instanceof LocalVariable variable && variable.slot() == slot) {
        int begin = place(code, variable.startScope());
        if (begin > stored && begin <= next) {
          return place(code, variable.endScope());
        }
      }
    }
    return code.size();
  }

  /** Whether what is loaded there is thrown, kept, returned or passed to somebody. */
  private static boolean isTaken(List<CodeElement> code, int loaded) {
    List<CodeElement> next =
        code.subList(loaded + 1, code.size()).stream()
            .filter(Instruction.class::isInstance)
            .limit(30)
            .toList();
    if (isAsked(next.getFirst())) {
      return false;
    }
    for (CodeElement element : next) {
      switch (element) {
        case ThrowInstruction thrown -> {
          return element == next.getFirst();
        }
        case ReturnInstruction returned -> {
          return element == next.getFirst();
        }
        case StoreInstruction copied -> {
          return element == next.getFirst();
        }
        case FieldInstruction field when isPut(field) -> {
          return TAKING.contains(field.type().stringValue());
        }
        case InvokeInstruction call when takes(call.typeSymbol()) -> {
          return !TEXTS.contains(call.owner().asInternalName() + "." + call.name().stringValue());
        }
        case InvokeDynamicInstruction made when takes(made.typeSymbol()) -> {
          return !made.name().equalsString("makeConcatWithConstants");
        }
        default -> {}
      }
    }
    return false;
  }

  /** Whether it is only asked for something: its message, its class. */
  private static boolean isAsked(CodeElement next) {
    return next instanceof TypeCheckInstruction
        || next instanceof ArrayStoreInstruction
        || next instanceof InvokeInstruction call
            && call.opcode() != Opcode.INVOKESTATIC
            && call.typeSymbol().parameterCount() == 0;
  }

  private static boolean isPut(FieldInstruction field) {
    return field.opcode() == Opcode.PUTFIELD || field.opcode() == Opcode.PUTSTATIC;
  }

  private static boolean takes(MethodTypeDesc called) {
    return called.parameterList().stream()
        .map(ClassDesc::descriptorString)
        .anyMatch(TAKING::contains);
  }
}
