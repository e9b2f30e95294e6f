package org.urbi.tests;

import static com.tngtech.archunit.lang.SimpleConditionEvent.violated;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import java.lang.classfile.constantpool.ClassEntry;
import java.lang.classfile.constantpool.PoolEntry;

/**
 * What each program uses in its first second is in the start-up cache, all of it. A {@code switch}
 * over types is not: the Java machine makes a class for it when it is first executed, which takes 5
 * to 10 ms. There, {@code instanceof} does the same.
 */
final class StartLaw {
  private StartLaw() {}

  private static final String MAKER = "java/lang/runtime/SwitchBootstraps";

  @ArchTest
  static final ArchRule nothingIsMadeInTheFirstSecond =
      classes()
          .that()
          .resideInAnyPackage(
              "org.urbi.lang.parse",
              "org.urbi.kernel.compile",
              "org.urbi.kernel.node",
              "org.urbi.kernel.object",
              "org.urbi.kernel.event",
              "org.urbi.kernel.job",
              "org.urbi.kernel.library.value",
              "org.urbi.kernel.tier")
          .should(
              new ArchCondition<JavaClass>("have no switch over types") {
                @Override
                public void check(JavaClass type, ConditionEvents events) {
                  for (PoolEntry entry : CatchLaw.classFile(type).constantPool()) {
                    if (entry instanceof ClassEntry used && used.asInternalName().equals(MAKER)) {
                      events.add(violated(type, type.getName() + " has a switch over types"));
                    }
                  }
                }
              });
}
