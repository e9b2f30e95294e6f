package org.urbi.lang.advice;

import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Ast;
import org.urbi.lang.source.Span;

/** The names that are known within a part of a statement only, of which people ask outside. */
public final class LocalDeclarations {
  private LocalDeclarations() {}

  /** The local variables that a statement declares, with the places where it does. */
  public static Map<String, Span> in(Ast statement) {
    Map<String, Span> found = new LinkedHashMap<>();
    // What is declared in the braces of a class is a slot.
    Set<Object> ofSlots = Collections.newSetFromMap(new IdentityHashMap<>());
    SuspectCode.walk(
        statement,
        part -> {
          switch (part) {
            case Ast.ClassDefinition type -> ofSlots.add(bodyOf(type));
            case Ast.PackageDefinition names -> ofSlots.add(names.body());
            case Ast.Do block -> ofSlots.add(block.body());
            case Ast.Scope scope -> {
              if (!ofSlots.contains(scope)) {
                scope.body().statements().forEach(each -> add(found, each));
              }
            }
            case Ast.At at -> add(found, at.body());
            case Ast.Every every -> add(found, every.body());
            case Ast.ForEach loop -> add(found, loop.body());
            case Ast.For loop -> add(found, loop.body());
            default -> {}
          }
        });
    return found;
  }

  private static Object bodyOf(Ast.ClassDefinition type) {
    return type.body() == null ? type : type.body();
  }

  private static void add(Map<String, Span> found, @Nullable Ast statement) {
    if (statement instanceof Ast.Declaration declaration && declaration.target() == null) {
      found.put(declaration.name(), declaration.nameSpan());
    }
  }
}
