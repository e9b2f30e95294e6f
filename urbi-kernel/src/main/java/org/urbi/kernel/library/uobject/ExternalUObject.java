package org.urbi.kernel.library.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiTypePart;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.external.ExternalProcess;
import org.urbi.kernel.external.ValueText;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.library.system.Evaluation;
import org.urbi.kernel.lobby.Diagnostics;
import org.urbi.kernel.lobby.RemoteObjects;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.uobject.ObjectAccess;
import org.urbi.kernel.uobject.PluggedContext;
import urbi.UValue;

/** The functions that processes linked with the SDK of Urbi 2.7 call. */
@UrbiTypePart(value = "UObject", needs = Permission.OWNER)
final class ExternalUObject {
  private final PluggedContext uobjects;
  private final ObjectAccess objects;

  ExternalUObject(PluggedContext uobjects) {
    this.uobjects = uobjects;
    this.objects = new ObjectAccess(uobjects);
  }

  @Builtin(doc = "The result of a call of a function of the process at the other end.")
  void funCall(Frame frame, UrbiObject self, String call, @Nullable @Optional UrbiObject result) {
    ExternalProcess process = ExternalProcess.of(frame, uobjects);
    UrbiObject exception = frame.interpreter().world().prototype("Exception");
    ExternalProcess.attempt(
        frame,
        "funCall",
        () -> {
          if (result != null && result.isA(exception)) {
            String text = frame.interpreter().asString(frame, result);
            process.reply(call, null, Utf8Text.toJava(text));
          } else {
            UValue value = result == null ? new UValue() : objects.toJava("funCall", result);
            process.reply(call, value, null);
          }
        });
  }

  @Builtin(
      doc = "Evaluates text, and sends the value, or what went wrong, on the channel of that name.")
  void syncGet(Frame frame, CallSite site, UrbiObject self, String exp, String tag) {
    UrbiLobby lobby = LobbyType.of(frame);
    String answer;
    try {
      UrbiObject value = Evaluation.eval(frame, site, lobby, exp, null);
      answer = ValueText.of(objects.toJava("syncGet", value));
    } catch (UrbiException e) {
      String text = frame.interpreter().asString(frame, e.value());
      answer = Diagnostics.marked(text.replace('\n', ' '));
    }
    lobby.output().send(tag, answer);
  }

  @Builtin(doc = "The process at the other end uses a variable so many times less.")
  void unnotify(Frame frame, UrbiObject self, String object, String slot, double count) {
    RemoteObjects used = LobbyType.of(frame).remoteObjects();
    if (used != null) {
      used.unnotify(Utf8Text.toJava(object + "." + slot), count);
    }
  }
}
