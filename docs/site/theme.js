// The switch between the system's colours, light and dark. That of furo in Debian 12 is a module
// which its pages don't load as one.
document.documentElement.classList.remove("no-js");
for (const button of document.getElementsByClassName("theme-toggle")) {
    button.addEventListener("click", function () {
        const system = matchMedia("(prefers-color-scheme: dark)").matches;
        const order = system ? ["auto", "light", "dark"] : ["auto", "dark", "light"];
        const next = order[(order.indexOf(document.body.dataset.theme) + 1) % order.length];
        document.body.dataset.theme = next;
        localStorage.setItem("theme", next);
    });
}
