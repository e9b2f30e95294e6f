package org.urbi.kernel.embed;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.Primitive;
import org.urbi.kernel.library.system.Evaluation;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.node.SlotUpdate;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;

/** Does what the program asks for; on the kernel thread. */
final class ProgramTasks {
  private final Embedding embedding;
  private final Interpreter interpreter;

  ProgramTasks(Embedding embedding) {
    this.embedding = embedding;
    this.interpreter = embedding.interpreter();
  }

  /**
   * Carries out a request, in a job.
   *
   * @return what the program gets for it
   */
  @Nullable Object run(Frame frame, Message.OfProgram asked, RequestAttachments attached) {
    return switch (asked) {
      case Message.OfObject wish -> ofObject(frame, wish, attached);
      case Message.ScopeWanted wish -> embedding.handle(wish.fresh() ? scope() : embedding.own());
      case Message.Listened wish -> {
        var events =
            new EventRegistration(embedding, wish.number(), wish.expression(), attached.listener());
        yield wish.changes()
            ? new ChangeRegistration(events, wish.expression()).run(frame)
            : events.run(frame);
      }
      case Message.FunctionDefined wish -> {
        define(frame, wish.name(), requireNonNull(attached.function(), "a program defines it"));
        yield null;
      }
    };
  }

  private @Nullable Object ofObject(
      Frame frame, Message.OfObject asked, RequestAttachments attached) {
    UrbiObject object =
        asked.object() == 0
            ? frame.self()
            : requireNonNull(attached.objects().get(asked.object()), "whoever asks has the object");
    var given = new FromDataConverter(frame, attached.objects());
    return switch (asked) {
      case Message.SourceEvaluated text ->
          JavaValues.toJava(
              embedding,
              Evaluation.eval(frame, null, object, text.source(), text.file()),
              text.form());
      case Message.MethodCalled call -> {
        int dot = asked.object() == 0 ? call.function().lastIndexOf('.') : -1;
        UrbiObject target = dot < 0 ? object : find(frame, call.function().substring(0, dot));
        yield JavaValues.toJava(
            embedding,
            interpreter.send(
                frame,
                target,
                call.function().substring(dot + 1),
                given.arguments(call.arguments())));
      }
      case Message.ObjectCalled call ->
          JavaValues.toJava(
              embedding,
              interpreter.call(
                  frame, object, frame.job().lobby(), given.arguments(call.arguments())));
      case Message.SlotRead read ->
          JavaValues.toJava(embedding, interpreter.get(frame, object, symbol(read.slot())));
      case Message.SlotWritten written -> {
        write(frame, object, symbol(written.slot()), given.object(written.value()));
        yield null;
      }
      case Message.SlotSought sought -> object.hasLocalSlot(symbol(sought.slot()));
      case Message.SlotRemoved removed -> object.removeSlot(symbol(removed.slot()));
      case Message.SlotsListed listed -> slotNames(object);
      case Message.ObjectShown shown -> Utf8Text.toJava(interpreter.asString(frame, object));
    };
  }

  private Symbol symbol(String name) {
    return interpreter.world().symbol(name);
  }

  private UrbiLobby scope() {
    UrbiLobby own = embedding.own();
    return new UrbiLobby(own.cloneShape(), own.connectionTag());
  }

  private UrbiObject find(Frame frame, String path) {
    UrbiObject found = frame.self();
    for (String name : path.split("\\.", -1)) {
      found = interpreter.send(frame, found, name);
    }
    return found;
  }

  private static void write(Frame frame, UrbiObject object, Symbol slot, UrbiObject value) {
    if (object.hasLocalSlot(slot)) {
      SlotUpdate.assign(frame, object, slot, value);
    } else {
      SlotUpdate.create(frame, object, slot, value);
    }
  }

  private static List<String> slotNames(UrbiObject object) {
    List<String> names = new ArrayList<>();
    for (Symbol name : object.localSlotNames()) {
      names.add(Utf8Text.toJava(name.name()));
    }
    return names;
  }

  private void define(Frame frame, String name, JavaFunction function) {
    int dot = name.lastIndexOf('.');
    UrbiObject owner =
        dot < 0 ? interpreter.world().prototype("Global") : find(frame, name.substring(0, dot));
    Symbol symbol = symbol(name.substring(dot + 1));
    owner.removeSlot(symbol);
    owner.addSlot(symbol, new Primitive(interpreter.prototypes().primitiveShape(), function, 0));
  }
}
