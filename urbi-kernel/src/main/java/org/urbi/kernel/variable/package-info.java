/** Variables that can be watched, and the connections between them (manual, "UVar"). */
package org.urbi.kernel.variable;
