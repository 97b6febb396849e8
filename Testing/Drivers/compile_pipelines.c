/*
 * Compile SPIR-V into a pipeline on the first Vulkan device, and print what its driver tells of the result.
 *
 *   compile_pipelines SHADER.spv... [BINDING:KIND]...
 *
 * The names of the shaders end in .vert.spv, .geom.spv, .frag.spv or .comp.spv. KIND is one of ubo, ssbo, image, buffer-image,
 * buffer-texture and texture. The first line is the device, the second
 *
 *   ok|failed WALL s CPU s
 *
 * and those that follow, with two spaces before them, have the statistics of the fragment or compute shader.
 * RADV needs no device: RADV_FORCE_FAMILY=navi21 names one that it compiles for.
 * Exit status 1 if the driver fails, 2 if nothing could be tried.
 */
#define _GNU_SOURCE
#include <vulkan/vulkan.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum
{
  MAX_BINDINGS = 64,
  MAX_STAGES = 3,
  MAX_EXECUTABLES = 8,
  MAX_STATISTICS = 64
};

struct Request
{
  VkPipelineShaderStageCreateInfo Stages[MAX_STAGES];
  uint32_t NumberOfStages;
  VkDescriptorSetLayoutBinding Bindings[MAX_BINDINGS];
  uint32_t NumberOfBindings;
};

static void stop(const char* why)
{
  fprintf(stderr, "compile_pipelines: %s\n", why);
  exit(2);
}

static double seconds(clockid_t clock)
{
  struct timespec now;
  clock_gettime(clock, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int ends_with(const char* text, const char* ending)
{
  const size_t length = strlen(text);
  const size_t size = strlen(ending);
  return length >= size && strcmp(text + length - size, ending) == 0;
}

/* A device with one queue and what the shaders of A-buffers need; its name is printed. */
static VkDevice open_device(void)
{
  VkApplicationInfo application = { .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
    .apiVersion = VK_API_VERSION_1_3 };
  VkInstanceCreateInfo instance_info = { .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
    .pApplicationInfo = &application };
  VkInstance instance;
  uint32_t count = 1;
  VkPhysicalDevice physical;
  if (vkCreateInstance(&instance_info, NULL, &instance) != VK_SUCCESS ||
    vkEnumeratePhysicalDevices(instance, &count, &physical) < 0 || count == 0)
  {
    stop("Vulkan has no device");
  }
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  printf("%s\n", properties.deviceName);

  VkPhysicalDeviceFeatures supported;
  vkGetPhysicalDeviceFeatures(physical, &supported);
  VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics = {
    .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
    .pipelineExecutableInfo = VK_TRUE
  };
  VkPhysicalDeviceVulkan13Features rendering = { .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
    .pNext = &statistics, .dynamicRendering = VK_TRUE };
  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue = { .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1,
    .pQueuePriorities = &priority };
  const char* extensions[] = { VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME };
  VkDeviceCreateInfo device_info = { .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .pNext = &rendering,
    .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue, .enabledExtensionCount = 1,
    .ppEnabledExtensionNames = extensions, .pEnabledFeatures = &supported };
  VkDevice device;
  if (vkCreateDevice(physical, &device_info, NULL, &device) != VK_SUCCESS)
  {
    stop("Vulkan's device lacks VK_KHR_pipeline_executable_properties or dynamic rendering");
  }
  return device;
}

static void add_stage(struct Request* request, VkDevice device, const char* path)
{
  FILE* file = fopen(path, "rb");
  if (!file || request->NumberOfStages == MAX_STAGES)
  {
    stop(path);
  }
  fseek(file, 0, SEEK_END);
  const size_t size = (size_t)ftell(file);
  rewind(file);
  uint32_t* code = malloc(size);
  if (fread(code, 1, size, file) != size)
  {
    stop(path);
  }
  fclose(file);
  VkShaderModuleCreateInfo module_info = { .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
    .codeSize = size, .pCode = code };
  VkPipelineShaderStageCreateInfo stage = { .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
    .pName = "main",
    .stage = ends_with(path, ".vert.spv") ? VK_SHADER_STAGE_VERTEX_BIT
      : ends_with(path, ".geom.spv")      ? VK_SHADER_STAGE_GEOMETRY_BIT
      : ends_with(path, ".comp.spv")      ? VK_SHADER_STAGE_COMPUTE_BIT
                                          : VK_SHADER_STAGE_FRAGMENT_BIT };
  if (vkCreateShaderModule(device, &module_info, NULL, &stage.module) != VK_SUCCESS)
  {
    stop(path);
  }
  free(code);
  request->Stages[request->NumberOfStages++] = stage;
}

static void add_binding(struct Request* request, const char* text)
{
  static const struct
  {
    const char* name;
    VkDescriptorType type;
  } kinds[] = { { "ubo", VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER }, { "ssbo", VK_DESCRIPTOR_TYPE_STORAGE_BUFFER },
    { "image", VK_DESCRIPTOR_TYPE_STORAGE_IMAGE }, { "buffer-image", VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER },
    { "buffer-texture", VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER },
    { "texture", VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER } };
  unsigned binding;
  char kind[32];
  if (sscanf(text, "%u:%31s", &binding, kind) != 2 || request->NumberOfBindings == MAX_BINDINGS)
  {
    stop(text);
  }
  for (size_t i = 0; i < sizeof kinds / sizeof *kinds; ++i)
  {
    if (strcmp(kind, kinds[i].name) == 0)
    {
      request->Bindings[request->NumberOfBindings++] = (VkDescriptorSetLayoutBinding){ .binding = binding,
        .descriptorType = kinds[i].type, .descriptorCount = 1, .stageFlags = VK_SHADER_STAGE_ALL };
      return;
    }
  }
  stop(text);
}

static VkPipelineLayout make_layout(VkDevice device, const struct Request* request)
{
  VkDescriptorSetLayoutCreateInfo set_info = { .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
    .bindingCount = request->NumberOfBindings, .pBindings = request->Bindings };
  VkDescriptorSetLayout set;
  VkPipelineLayoutCreateInfo layout_info = { .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
    .setLayoutCount = 1, .pSetLayouts = &set };
  VkPipelineLayout layout;
  if (vkCreateDescriptorSetLayout(device, &set_info, NULL, &set) != VK_SUCCESS ||
    vkCreatePipelineLayout(device, &layout_info, NULL, &layout) != VK_SUCCESS)
  {
    stop("no layout");
  }
  return layout;
}

static VkResult make_compute(VkDevice device, const struct Request* request, VkPipelineLayout layout, VkPipeline* made)
{
  VkComputePipelineCreateInfo info = { .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
    .flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR, .stage = request->Stages[0], .layout = layout };
  return vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &info, NULL, made);
}

/* Strips of triangles, or points for three stages, without vertex attributes, over two RGBA8 targets of one sample. */
static VkResult make_graphics(VkDevice device, const struct Request* request, VkPipelineLayout layout, VkPipeline* made)
{
  VkPipelineVertexInputStateCreateInfo input = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO
  };
  VkPipelineInputAssemblyStateCreateInfo assembly = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
    .topology = request->NumberOfStages == MAX_STAGES ? VK_PRIMITIVE_TOPOLOGY_POINT_LIST
                                                      : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP
  };
  VkViewport viewport = { 0, 0, 64, 64, 0, 1 };
  VkRect2D scissor = { { 0, 0 }, { 64, 64 } };
  VkPipelineViewportStateCreateInfo views = { .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
    .viewportCount = 1, .pViewports = &viewport, .scissorCount = 1, .pScissors = &scissor };
  VkPipelineRasterizationStateCreateInfo raster = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1
  };
  VkPipelineMultisampleStateCreateInfo samples = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
    .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT
  };
  VkPipelineColorBlendAttachmentState targets[2] = { { .colorWriteMask = 15 }, { .colorWriteMask = 15 } };
  VkPipelineColorBlendStateCreateInfo blend = { .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
    .attachmentCount = 2, .pAttachments = targets };
  VkFormat formats[2] = { VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM };
  VkPipelineRenderingCreateInfo rendering = { .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
    .colorAttachmentCount = 2, .pColorAttachmentFormats = formats };
  VkGraphicsPipelineCreateInfo info = { .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
    .pNext = &rendering, .flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR,
    .stageCount = request->NumberOfStages, .pStages = request->Stages, .pVertexInputState = &input,
    .pInputAssemblyState = &assembly, .pViewportState = &views, .pRasterizationState = &raster,
    .pMultisampleState = &samples, .pColorBlendState = &blend, .layout = layout };
  return vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, NULL, made);
}

static void print_statistics(VkDevice device, VkPipeline pipeline)
{
  PFN_vkGetPipelineExecutablePropertiesKHR get_executables =
    (PFN_vkGetPipelineExecutablePropertiesKHR)vkGetDeviceProcAddr(device, "vkGetPipelineExecutablePropertiesKHR");
  PFN_vkGetPipelineExecutableStatisticsKHR get_statistics =
    (PFN_vkGetPipelineExecutableStatisticsKHR)vkGetDeviceProcAddr(device, "vkGetPipelineExecutableStatisticsKHR");
  VkPipelineInfoKHR pipeline_info = { .sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR, .pipeline = pipeline };
  VkPipelineExecutablePropertiesKHR executables[MAX_EXECUTABLES];
  uint32_t count = MAX_EXECUTABLES;
  for (int i = 0; i < MAX_EXECUTABLES; ++i)
  {
    executables[i] = (VkPipelineExecutablePropertiesKHR){
      .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR
    };
  }
  get_executables(device, &pipeline_info, &count, executables);
  for (uint32_t i = 0; i < count; ++i)
  {
    if (!(executables[i].stages & (VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT)))
    {
      continue;
    }
    VkPipelineExecutableInfoKHR which = { .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
      .pipeline = pipeline, .executableIndex = i };
    VkPipelineExecutableStatisticKHR statistics[MAX_STATISTICS];
    uint32_t number = MAX_STATISTICS;
    for (int k = 0; k < MAX_STATISTICS; ++k)
    {
      statistics[k] = (VkPipelineExecutableStatisticKHR){
        .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR
      };
    }
    get_statistics(device, &which, &number, statistics);
    for (uint32_t k = 0; k < number; ++k)
    {
      if (statistics[k].format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
      {
        printf("  %s: %llu\n", statistics[k].name, (unsigned long long)statistics[k].value.u64);
      }
    }
  }
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    fprintf(stderr, "usage: compile_pipelines SHADER.spv... [BINDING:KIND]...\n");
    return 2;
  }
  VkDevice device = open_device();
  struct Request request = { 0 };
  for (int i = 1; i < argc; ++i)
  {
    if (ends_with(argv[i], ".spv"))
    {
      add_stage(&request, device, argv[i]);
    }
    else
    {
      add_binding(&request, argv[i]);
    }
  }
  VkPipelineLayout layout = make_layout(device, &request);
  VkPipeline pipeline = VK_NULL_HANDLE;
  const double wall = seconds(CLOCK_MONOTONIC);
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
  const VkResult result = request.Stages[0].stage == VK_SHADER_STAGE_COMPUTE_BIT
    ? make_compute(device, &request, layout, &pipeline)
    : make_graphics(device, &request, layout, &pipeline);
  printf("%s %.3f s %.3f s\n", result == VK_SUCCESS ? "ok" : "failed", seconds(CLOCK_MONOTONIC) - wall,
    seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
  if (result != VK_SUCCESS)
  {
    return 1;
  }
  print_statistics(device, pipeline);
  return 0;
}
