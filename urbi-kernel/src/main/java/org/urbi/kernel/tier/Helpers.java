package org.urbi.kernel.tier;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.constantpool.MethodRefEntry;
import java.lang.constant.ClassDesc;
import java.lang.constant.MethodTypeDesc;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The helpers that one class calls, as its constant pool has them. To find one there by its name
 * and types takes longer than all else of emitting a call, and most are called at many places.
 */
final class Helpers {
  private record Helper(ClassDesc result, ClassDesc[] parameters, MethodRefEntry entry) {
    boolean has(ClassDesc otherResult, ClassDesc[] otherParameters) {
      return result.equals(otherResult) && Arrays.equals(parameters, otherParameters);
    }
  }

  private final Map<String, List<Helper>> known = new HashMap<>();

  /** Calls a method of the superclass. */
  void call(CodeBuilder code, String name, ClassDesc result, ClassDesc... parameters) {
    List<Helper> named = known.computeIfAbsent(name, each -> new ArrayList<>(1));
    for (Helper helper : named) {
      if (helper.has(result, parameters)) {
        code.invokestatic(helper.entry);
        return;
      }
    }
    MethodRefEntry entry =
        code.constantPool()
            .methodRefEntry(Names.COMPILED_CODE, name, MethodTypeDesc.of(result, parameters));
    named.add(new Helper(result, parameters, entry));
    code.invokestatic(entry);
  }
}
